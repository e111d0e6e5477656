"""Two texts compared."""

from __future__ import annotations

import math

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.utilities import describe_substitutions, to_text

_TRUTH = {'true': True, '1': True, 'false': False, '0': False}


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
        left, right = to_text(context, self._left), to_text(context, self._right)
        if left.lower() in _TRUTH and right.lower() in _TRUTH:
            return _TRUTH[left.lower()] == _TRUTH[right.lower()]
        try:
            return math.isclose(float(left), float(right))
        except ValueError:
            return left == right


def _writable(value) -> SomeSubstitutionsType:
    if value is None:
        return ''
    return str(value) if isinstance(value, (bool, int, float)) else value
