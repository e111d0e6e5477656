"""
Wait until a node that has just been created knows the graph.

DDS has no message "this is all". Stock `ros2` waits half a second without a daemon, and on a busy machine lists what it
has seen by then: a participant repeats its announcement every three seconds, so one that is lost costs that long. Here
the operating system is asked how many DDS participants this machine has in the domain (each owns a UDP port of a known
number), and the wait ends when all of them have told their nodes and nothing has changed for a short while.

A datagram that gets lost on a busy machine holds up all that its participant would tell after it, for longer than that.
The operating system counts the datagrams for which a buffer had no room; while it does, and a little longer, the wait
goes on. Writers and readers are told apart, so what belongs together shows the gap, too: the topics of a service, and
of an action.
"""

import contextlib
import os
import time
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

# Seconds that nodes on other machines get, as with stock.
REMOTE_TIME = 0.5
# Seconds after which the graph is taken as it is, two of Fast DDS's announcement periods; so many after the last
# datagram was lost, but no more than twice as many in all.
LONGEST_TIME = 6.0
# A look at the graph every so many seconds …
_PERIOD = 0.01
# … and it is at rest when so many looks in a row, over so many seconds, saw the same. On a busy machine looks are rare.
_QUIET_LOOKS = 6
_QUIET_TIME = 0.25
# Seconds after a loss in which more may come: Fast DDS says every second what it has told of its endpoints, and repeats
# what was not received 0.1 s after it is asked (edp_heartbeat_period, edp_nack_response_delay in its EDPSimple.cpp).
_RECOVERY_TIME = 1.3

# What the middleware calls the node of an endpoint that it has heard of before the node.
_UNKNOWN_NODE = '_NODE_NAME_UNKNOWN_'
# So many bytes of an endpoint's GID are those of its participant.
_PARTICIPANT_BYTES = 12
# Every node publishes on these.
_TOPICS_OF_ALL = ('/rosout', '/parameter_events')

# DDSI-RTPS 9.6.2.3: where the discovery ports of a domain are.
_PORT_BASE, _PORTS_PER_DOMAIN, _FIRST_UNICAST_PORT = 7400, 250, 10


def wait_for_graph(node: Any) -> None:
    """Return as soon as the node knows the graph, at the latest after LONGEST_TIME; see there."""
    start = now = time.monotonic()
    earliest = start if _only_this_machine() else start + REMOTE_TIME
    latest = start + LONGEST_TIME
    domain_id = node.context.get_domain_id()
    lost_before = _lost_before(domain_id)
    last, looks, quiet_since, lost = None, 0, start, 0
    while now < latest:
        sockets = _discovery_sockets(domain_id)
        look = (_look(node), {socket.port for socket in sockets})
        lost_now = sum(max(0, socket.lost - lost_before.get(socket.inode, 0)) for socket in sockets)
        looks += 1
        now = time.monotonic()
        if look != last:
            last, looks, quiet_since = look, 0, now
        if lost_now > lost:
            earliest = max(earliest, now + _RECOVERY_TIME)
            latest = min(now, start + LONGEST_TIME) + LONGEST_TIME
        lost = lost_now
        at_rest = looks >= _QUIET_LOOKS and now >= quiet_since + _QUIET_TIME
        if at_rest and now >= earliest and _all_here(node, len(look[1])) and _all_whole(node):
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


def _all_here(node: Any, participants: int) -> bool:
    """Return whether so many participants have been heard, and each one heard has named its nodes."""
    # Each participant, this one too, has one writer of ros_discovery_info, on which it names its nodes.
    heard = _participants(node.get_publishers_info_by_topic('ros_discovery_info', no_mangle=True))
    named = set()
    for topic in _TOPICS_OF_ALL:
        endpoints = node.get_publishers_info_by_topic(topic)
        named |= _participants(each for each in endpoints if each.node_name != _UNKNOWN_NODE)
    return len(heard) >= participants and heard <= named


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


@dataclass(frozen=True)
class _Socket:
    """A UDP socket of some process: its port, the number of its inode, and how many datagrams it had no room for."""

    port: int
    inode: str
    lost: int


def _lost_before(domain_id: int) -> dict[str, int]:
    """Return what the sockets of other processes have lost so far, by their inodes."""
    own = set()
    for link in Path('/proc/self/fd').glob('*'):
        with contextlib.suppress(OSError):  # closed meanwhile
            own.add(os.readlink(link))
    return {each.inode: each.lost for each in _discovery_sockets(domain_id) if f'socket:[{each.inode}]' not in own}


def _discovery_sockets(domain_id: int) -> list[_Socket]:
    """Return who listens to the discovery ports of the domain on this machine; nothing if that is unknown."""
    first = _PORT_BASE + _PORTS_PER_DOMAIN * domain_id
    wanted = range(first + _FIRST_UNICAST_PORT, first + _PORTS_PER_DOMAIN, 2)
    found = []
    for table in ('/proc/net/udp', '/proc/net/udp6'):
        try:
            lines = Path(table).read_text().splitlines()[1:]
        except OSError:
            continue
        for line in lines:
            # Its columns: man 5 proc.
            words = line.split()
            port = int(words[1].rpartition(':')[2], 16)
            if port in wanted:
                found.append(_Socket(port, words[9], int(words[12])))
    return found
