"""The base of all that a launch description holds."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class LaunchDescriptionEntity:
    """A part of a launch description. Visiting it does what it says and returns the parts to visit next."""

    def visit(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Take effect in the context; return the entities to visit next, if any."""
        raise NotImplementedError

    def describe(self) -> str:
        """Return a line of text for ``ros2 launch --print``."""
        return f"Action('{self}')"

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that a visit will surely lead to, as far as is known without launching."""
        return []

    def describe_conditional_sub_entities(self) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return (condition, entities) pairs of what a visit may lead to."""
        return []

    def get_asyncio_future(self) -> asyncio.Future | None:
        """Return a future that is done when the visit's work is; None if it is done already."""
        return None
