"""What is known of a ROS graph at one moment."""

from dataclasses import dataclass
from functools import cached_property

from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

# What a node does with a topic, service or action; whether it stands before it (an arrow leads from the node to it).
ROLES = {'publisher': True, 'subscription': False, 'client': True, 'server': False,
         'action client': True, 'action server': False}
KINDS = {'publisher': 'topic', 'subscription': 'topic', 'client': 'service', 'server': 'service',
         'action client': 'action', 'action server': 'action'}


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
        return self.qos is None or self.qos.reliability != ReliabilityPolicy.BEST_EFFORT

    @property
    def latched(self) -> bool:
        """TRANSIENT_LOCAL durability: late joiners get the last messages."""
        return self.qos is not None and self.qos.durability == DurabilityPolicy.TRANSIENT_LOCAL

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


@dataclass(frozen=True)
class Graph:
    """The nodes (fully qualified; a name as often as there are nodes of it) and the edges of one domain."""

    domain_id: int
    nodes: tuple[str, ...]
    links: tuple[Link, ...]
    namespace: str = '/'  # only what stands in it, and what that is connected with

    @cached_property
    def problems(self) -> list[Problem]:
        """What does not fit, in a stable order."""
        from helpers.graph import problems

        return problems.find(self)

    @cached_property
    def key(self) -> tuple:
        """Equal for two graphs that look the same."""
        return self.domain_id, self.namespace, self.nodes, tuple(link.key for link in self.links)

    def names(self, kind: str) -> list[str]:
        """The topics, services or actions."""
        return sorted({link.name for link in self.links if link.kind == kind})


def _values(qos: QoSProfile) -> tuple:
    return tuple(str(getattr(qos, part)) for part in (
        'reliability', 'durability', 'liveliness', 'deadline', 'lifespan', 'liveliness_lease_duration'))
