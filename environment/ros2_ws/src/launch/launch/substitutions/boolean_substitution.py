"""Comparisons, as the texts ``true`` and ``false``."""

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import describe_substitutions, to_bool, to_text


class _Pair(Substitution):
    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType):
        self._left, self._right = left, right

    def describe(self) -> str:
        return f'{type(self).__name__}({describe_substitutions(self._left)} {describe_substitutions(self._right)})'

    def perform(self, context: LaunchContext) -> str:
        return str(self._decide(context)).lower()

    def _decide(self, context: LaunchContext) -> bool:
        raise NotImplementedError


class AndSubstitution(_Pair):
    """True if both are."""

    def _decide(self, context: LaunchContext) -> bool:
        return to_bool(context, self._left) and to_bool(context, self._right)


class OrSubstitution(_Pair):
    """True if one is."""

    def _decide(self, context: LaunchContext) -> bool:
        return to_bool(context, self._left) or to_bool(context, self._right)


class EqualsSubstitution(_Pair):
    """True if the two are the same text, truth value or number."""

    def _decide(self, context: LaunchContext) -> bool:
        left, right = to_text(context, self._left), to_text(context, self._right)
        return _value(left) == _value(right)


class NotEqualsSubstitution(EqualsSubstitution):
    """True if the two differ."""

    def _decide(self, context: LaunchContext) -> bool:
        return not super()._decide(context)


class NotSubstitution(Substitution):
    """True if the other is false."""

    def __init__(self, value: SomeSubstitutionsType):
        self._value = value

    def describe(self) -> str:
        return f'NotSubstitution({describe_substitutions(self._value)})'

    def perform(self, context: LaunchContext) -> str:
        return str(not to_bool(context, self._value)).lower()


class IfElseSubstitution(Substitution):
    """One of two texts."""

    def __init__(
        self,
        condition: SomeSubstitutionsType,
        if_value: SomeSubstitutionsType = '',
        else_value: SomeSubstitutionsType = '',
    ):
        self._condition, self._if, self._else = condition, if_value, else_value

    def describe(self) -> str:
        return f'IfElseSubstitution({describe_substitutions(self._condition)})'

    def perform(self, context: LaunchContext) -> str:
        return to_text(context, self._if if to_bool(context, self._condition) else self._else)


def _value(text: str):
    if text.strip().lower() in ('true', 'false'):
        return text.strip().lower()
    try:
        return float(text)
    except ValueError:
        return text
