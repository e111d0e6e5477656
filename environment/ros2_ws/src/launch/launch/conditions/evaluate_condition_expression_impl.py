"""What the text of a condition means."""

from launch.conditions.invalid_condition_expression_error import InvalidConditionExpressionError
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text

_TRUE, _FALSE = ('true', '1'), ('false', '0')


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
