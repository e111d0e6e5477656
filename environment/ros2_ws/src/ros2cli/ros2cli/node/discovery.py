"""
Wait until a node that has just been created knows the graph.

DDS has no message "this is all". Stock `ros2` waits half a second without a daemon, and on a busy machine lists what it
has seen by then: a participant repeats its announcement every three seconds, so one that is lost costs that long. Here
the operating system is asked how many DDS participants this machine has in the domain (each owns a UDP port of a known
number), and the wait ends when all of them have told their nodes and nothing has changed for a short while.

A datagram that gets lost on a busy machine holds up all that its participant would tell after it, for longer than that.
Writers and readers are told apart, so what belongs together shows the gap: the topics of a service, and of an action.
"""

import os
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Any

# Seconds that nodes on other machines get, as with stock.
REMOTE_TIME = 0.5
# Seconds after which the graph is taken as it is: two of Fast DDS's announcement periods.
LONGEST_TIME = 6.0
# A look at the graph every so many seconds …
_PERIOD = 0.01
# … and it is at rest when so many looks in a row, over so many seconds, saw the same. On a busy machine looks are rare.
_QUIET_LOOKS = 6
_QUIET_TIME = 0.25

# What the middleware calls the node of an endpoint that it has heard of before the node.
_UNKNOWN_NODE = '_NODE_NAME_UNKNOWN_'
# So many bytes of an endpoint's GID are those of its participant.
_PARTICIPANT_BYTES = 12
# Every node publishes on these.
_TOPICS_OF_ALL = ('/rosout', '/parameter_events')

# DDSI-RTPS 9.6.2.3: where the discovery ports of a domain are.
_PORT_BASE, _PORTS_PER_DOMAIN, _FIRST_UNICAST_PORT = 7400, 250, 10


def wait_for_graph(node: Any) -> None:
    """Return as soon as the node knows the graph, at the latest after LONGEST_TIME."""
    start = now = time.monotonic()
    earliest = start if _only_this_machine() else start + REMOTE_TIME
    domain_id = node.context.get_domain_id()
    last, looks, quiet_since = None, 0, start
    while now < start + LONGEST_TIME:
        look = _look(node)
        looks += 1
        now = time.monotonic()
        if look != last:
            last, looks, quiet_since = look, 0, now
        at_rest = looks >= _QUIET_LOOKS and now >= quiet_since + _QUIET_TIME
        if at_rest and now >= earliest and _all_here(node, domain_id) and _all_whole(node):
            return
        time.sleep(_PERIOD)


def _only_this_machine() -> bool:
    return (
        os.environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE', '').upper() == 'LOCALHOST'
        or os.environ.get('ROS_LOCALHOST_ONLY') == '1'
    )


def _look(node: Any) -> Any:
    topics = node.get_topic_names_and_types()
    return (
        sorted(node.get_node_names_and_namespaces()),
        sorted((name, node.count_publishers(name), node.count_subscribers(name)) for name, _ in topics),
        node.get_service_names_and_types(),
    )


def _all_here(node: Any, domain_id: int) -> bool:
    """Return whether each participant of this machine has been heard, and each one heard has named its nodes."""
    # Each participant, this one too, has one writer of ros_discovery_info, on which it names its nodes.
    heard = _participants(node.get_publishers_info_by_topic('ros_discovery_info', no_mangle=True))
    named = set()
    for topic in _TOPICS_OF_ALL:
        endpoints = node.get_publishers_info_by_topic(topic)
        named |= _participants(each for each in endpoints if each.node_name != _UNKNOWN_NODE)
    return len(heard) >= len(_local_ports(domain_id)) and heard <= named


def _all_whole(node: Any) -> bool:
    """Return whether each service and action that has been heard of has been heard of with all of its topics."""
    topics = {name for name, _ in node.get_topic_names_and_types(no_demangle=True)}
    services = {name[3:-7] for name in topics if name.startswith('rq/') and name.endswith('Request')}
    services |= {name[3:-5] for name in topics if name.startswith('rr/') and name.endswith('Reply')}
    return all(_whole(node, service) for service in services)


def _whole(node: Any, service: str) -> bool:
    def writers(topic: str) -> set[bytes]:
        return _participants(node.get_publishers_info_by_topic(topic, no_mangle=True))

    def readers(topic: str) -> set[bytes]:
        return _participants(node.get_subscriptions_info_by_topic(topic, no_mangle=True))

    request, reply = f'rq/{service}Request', f'rr/{service}Reply'
    servers = readers(request)
    if servers != writers(reply) or writers(request) != readers(reply):
        return False
    action = service.removesuffix('/_action/send_goal')
    return action == service or servers <= writers(f'rt/{action}/_action/feedback')


def _participants(endpoints: Iterable[Any]) -> set[bytes]:
    return {bytes(each.endpoint_gid[:_PARTICIPANT_BYTES]) for each in endpoints}


def _local_ports(domain_id: int) -> set[int]:
    """Return the discovery ports of the domain that some process of this machine has bound; empty if unknown."""
    first = _PORT_BASE + _PORTS_PER_DOMAIN * domain_id
    wanted = range(first + _FIRST_UNICAST_PORT, first + _PORTS_PER_DOMAIN, 2)
    ports = set()
    for table in ('/proc/net/udp', '/proc/net/udp6'):
        try:
            lines = Path(table).read_text().splitlines()[1:]
        except OSError:
            continue
        for line in lines:
            port = int(line.split()[1].rpartition(':')[2], 16)
            if port in wanted:
                ports.add(port)
    return ports
