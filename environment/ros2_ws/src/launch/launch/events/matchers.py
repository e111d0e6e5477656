"""Which action an event is for."""

from collections.abc import Callable


def matches_action(action) -> Callable[[object], bool]:
    """Return a matcher for the process of one action."""
    return lambda other: other is action
