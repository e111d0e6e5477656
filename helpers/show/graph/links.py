"""The edges of a ROS graph, and what may be wrong with them."""

from dataclasses import dataclass

from rclpy.qos import QoSProfile

from helpers.kernel.qos import is_latched, is_reliable

# What a node does with a topic, service or action; whether it stands before it (an arrow leads from the node to it).
ROLES = {
    'publisher': True,
    'subscription': False,
    'client': True,
    'server': False,
    'action client': True,
    'action server': False,
}
KINDS = {
    'publisher': 'topic',
    'subscription': 'topic',
    'client': 'service',
    'server': 'service',
    'action client': 'action',
    'action server': 'action',
}


@dataclass(frozen=True, eq=False)
class Link:
    """One edge of the graph: what a node does with a topic, service or action. Compare them by `key`."""

    node: str  # fully qualified
    role: str  # one of ROLES
    name: str  # of the topic, service or action, fully qualified
    type: str  # as std_msgs/msg/String
    qos: QoSProfile | None = None  # of publishers and subscriptions

    @property
    def out(self) -> bool:
        """Whether the node stands before it: a publisher, or a client."""
        return ROLES[self.role]

    @property
    def kind(self) -> str:
        """'topic', 'service' or 'action'."""
        return KINDS[self.role]

    @property
    def reliable(self) -> bool:
        """Whether nothing gets lost: services and actions, and endpoints that are known to be RELIABLE."""
        return self.qos is None or is_reliable(self.qos)

    @property
    def latched(self) -> bool:
        """TRANSIENT_LOCAL durability: late joiners get the last messages."""
        return self.qos is not None and is_latched(self.qos)

    @property
    def key(self) -> tuple:
        """What makes two edges equal, and their order."""
        return self.name, self.role, self.node, self.type, repr(self.qos and _values(self.qos))


@dataclass(frozen=True)
class Problem:
    """Something that does not fit: a sentence or two, and the edges and nodes that it is about."""

    kind: str  # 'type', 'qos', 'name', 'no server', 'servers', 'nodes'
    text: str
    links: tuple[Link, ...] = ()
    nodes: tuple[str, ...] = ()


def _values(qos: QoSProfile) -> tuple:
    return tuple(
        str(getattr(qos, part))
        for part in ('reliability', 'durability', 'liveliness', 'deadline', 'lifespan', 'liveliness_lease_duration')
    )
