"""Two texts compared."""

from __future__ import annotations

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.utilities import describe_substitutions, to_text


@expose_substitution('equals')
class EqualsSubstitution(Substitution):
    """True if the two are the same text, truth value or number."""

    def __init__(self, left: SomeSubstitutionsType | None, right: SomeSubstitutionsType | None):
        self._left, self._right = _writable(left), _writable(right)

    @classmethod
    def parse(cls, data):
        """Read ``$(equals left right)``."""
        left, right = counted('equals', data, 2)
        return cls, {'left': left, 'right': right}

    def describe(self) -> str:
        return f'{type(self).__name__}({describe_substitutions(self._left)} {describe_substitutions(self._right)})'

    def perform(self, context: LaunchContext) -> str:
        return str(self._same(context)).lower()

    def _same(self, context: LaunchContext) -> bool:
        return _value(to_text(context, self._left)) == _value(to_text(context, self._right))


def _writable(value) -> SomeSubstitutionsType:
    if value is None:
        return ''
    return str(value) if isinstance(value, (bool, int, float)) else value


def _value(text: str):
    if text.strip().lower() in ('true', 'false'):
        return text.strip().lower()
    try:
        return float(text)
    except ValueError:
        return text
