"""The base of all substitutions."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class Substitution:
    """A text that is known only while launching."""

    def describe(self) -> str:
        """Return how to show the substitution before it is performed."""
        return f"Substitution('{self}')"

    def perform(self, context: LaunchContext) -> str:
        """Return the text."""
        raise NotImplementedError
