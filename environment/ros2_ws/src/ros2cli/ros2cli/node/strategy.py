"""Upstream's name for "the daemon if it runs, otherwise a node of one's own". There is no daemon here."""

from ros2cli.node.arguments import add_arguments
from ros2cli.node.direct import DirectNode

__all__ = ['NodeStrategy', 'add_arguments']


class NodeStrategy(DirectNode):
    """A node of one's own."""

    @property
    def direct_node(self) -> DirectNode:
        """Return the node itself."""
        return self
