"""The base of all conditions."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class Condition:
    """A question that is answered when an action is about to be executed."""

    def __init__(self, *, predicate: Callable[[LaunchContext], bool]):
        self._predicate = predicate

    def evaluate(self, context: LaunchContext) -> bool:
        """Return the answer at this moment."""
        return self._predicate(context)
