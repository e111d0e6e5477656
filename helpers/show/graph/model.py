"""What is known of a ROS graph at one moment."""

from dataclasses import dataclass
from functools import cached_property

from helpers.show.graph import problems
from helpers.show.graph.links import Link, Problem


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
        return problems.find(self.nodes, self.links)

    @cached_property
    def key(self) -> tuple:
        """Equal for two graphs that look the same."""
        return self.domain_id, self.namespace, self.nodes, tuple(link.key for link in self.links)

    def names(self, kind: str) -> list[str]:
        """The topics, services or actions."""
        return sorted({link.name for link in self.links if link.kind == kind})
