"""Whether a node has heard of all DDS participants of this machine.

A new node needs a moment to hear of the programs that run already, and a busy machine makes this moment long: a graph
that does not change may be one of which nothing has come yet. How many participants there are is known elsewhere, from
their ports.
"""

from collections.abc import Iterable
from typing import Any

from helpers.kernel import domains

_PREFIX = 12  # bytes of an endpoint's GID that are its participant's
# What every participant publishes on, by its middleware's name; and what nodes publish on, as a rule.
_ANNOUNCED = 'ros_discovery_info'
_USUAL = ('/parameter_events', '/rosout')
_UNKNOWN = '_NODE_NAME_UNKNOWN_'


def all_heard(node: Any) -> bool:
    """False while `node` has not heard of a participant of this machine, or of the nodes of one that it has heard of.

    True if that cannot be told: with another middleware than Fast DDS, say, or on another system than Linux.
    """
    announced = _participants(node.get_publishers_info_by_topic(_ANNOUNCED, no_mangle=True))
    named: set[bytes] = set()
    for topic in _USUAL:
        infos = node.get_publishers_info_by_topic(topic)
        named |= _participants(info for info in infos if info.node_name != _UNKNOWN)
    return announced <= named and len(announced) >= domains.participants(node.context.get_domain_id())


def _participants(infos: Iterable[Any]) -> set[bytes]:
    return {bytes(info.endpoint_gid[:_PREFIX]) for info in infos}
