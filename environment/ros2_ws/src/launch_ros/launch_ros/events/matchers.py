"""Which nodes an event is for."""

from collections.abc import Callable
from typing import Any


def matches_node_name(node_name: str) -> Callable[[Any], bool]:
    """Return a matcher for the action of the node with this full name; the / in front may be left out."""
    full = node_name if node_name.startswith('/') else f'/{node_name}'
    return lambda action: action.node_name == full
