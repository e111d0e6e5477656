"""Conditions of actions."""

from __future__ import annotations

from launch.condition import Condition
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import to_text

__all__ = [
    'IfCondition',
    'InvalidConditionExpressionError',
    'LaunchConfigurationEquals',
    'LaunchConfigurationNotEquals',
    'UnlessCondition',
    'evaluate_condition_expression',
]

_TRUE, _FALSE = ('true', '1'), ('false', '0')


class InvalidConditionExpressionError(Exception):
    """The text of a condition is neither true nor false."""


def evaluate_condition_expression(context: LaunchContext, expression: SomeSubstitutionsType) -> bool:
    """
    Return what a text means: true or 1, false or 0, in any case.

    :raises InvalidConditionExpressionError: for any other text
    """
    text = to_text(context, expression)
    word = text.strip().lower()
    if word not in _TRUE + _FALSE:
        raise InvalidConditionExpressionError(
            f"invalid condition expression '{text}': expected one of {list(_TRUE)} or {list(_FALSE)}"
        )
    return word in _TRUE


class IfCondition(Condition):
    """True if a text means true."""

    def __init__(self, predicate_expression: SomeSubstitutionsType):
        super().__init__(predicate=lambda context: evaluate_condition_expression(context, predicate_expression))


class UnlessCondition(Condition):
    """True if a text means false."""

    def __init__(self, predicate_expression: SomeSubstitutionsType):
        super().__init__(predicate=lambda context: not evaluate_condition_expression(context, predicate_expression))


class LaunchConfigurationEquals(Condition):
    """True if a launch configuration has a value; an expected value of None means that it is not set."""

    def __init__(self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None):
        self._name, self._expected = launch_configuration_name, expected_value
        super().__init__(predicate=self._equals)

    def _equals(self, context: LaunchContext) -> bool:
        value = context.launch_configurations.get(self._name)
        if self._expected is None or value is None:
            return value is self._expected
        if isinstance(self._expected, (str, Substitution, list, tuple)):
            return value == to_text(context, self._expected)
        return value == self._expected


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """True if a launch configuration does not have a value."""

    def _equals(self, context: LaunchContext) -> bool:
        return not super()._equals(context)
