"""
Wait until a node that has just been created knows the graph.

DDS has no message "this is all". Stock `ros2` waits half a second without a daemon, and on a busy machine lists what it
has seen by then: a participant repeats its announcement every three seconds, so one that is lost costs that long. Here
the operating system is asked how many DDS participants this machine has in the domain (each owns a UDP port of a known
number), and the wait ends when all of them have told their nodes and nothing has changed for a short while.
"""

import os
import time
from pathlib import Path
from typing import Any

# Seconds that nodes on other machines get, as with stock.
REMOTE_TIME = 0.5
# Seconds after which the graph is taken as it is. Longer than Fast DDS's announcement period of 3 s.
LONGEST_TIME = 5.0
# A look at the graph every so many seconds …
_PERIOD = 0.01
# … and it is at rest when so many looks in a row, over so many seconds, saw the same. On a busy machine looks are rare.
_QUIET_LOOKS = 6
_QUIET_TIME = 0.25

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
        if at_rest and now >= earliest and _all_here(node, domain_id):
            return
        time.sleep(_PERIOD)


def _only_this_machine() -> bool:
    return (os.environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE', '').upper() == 'LOCALHOST'
            or os.environ.get('ROS_LOCALHOST_ONLY') == '1')


def _look(node: Any) -> Any:
    topics = node.get_topic_names_and_types()
    return (
        sorted(node.get_node_names_and_namespaces()),
        sorted((name, node.count_publishers(name), node.count_subscribers(name)) for name, _ in topics),
        node.get_service_names_and_types(),
    )


def _all_here(node: Any, domain_id: int) -> bool:
    # Each participant, this one too, has one writer of ros_discovery_info, which names its nodes.
    heard = len(node.get_publishers_info_by_topic('ros_discovery_info', no_mangle=True))
    return heard >= len(_local_ports(domain_id)) and len(node.get_node_names()) >= heard


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
