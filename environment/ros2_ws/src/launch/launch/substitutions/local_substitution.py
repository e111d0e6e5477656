"""A local variable of the context."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure


class LocalSubstitution(Substitution):
    """A local variable of the context, e.g. ``event.reason`` in a handler of a shutdown."""

    def __init__(self, expression: str, description: str | None = None):
        self._expression, self._description = expression, description or expression

    def describe(self) -> str:
        return f"LocalVar('{self._description}')"

    def perform(self, context: LaunchContext) -> str:
        first, *rest = self._expression.split('.')
        try:
            value = context.get_locals_as_dict()[first]
            for name in rest:
                value = getattr(value, name)
        except (KeyError, AttributeError):
            raise SubstitutionFailure(f"local variable '{self._expression}' does not exist") from None
        return str(value)
