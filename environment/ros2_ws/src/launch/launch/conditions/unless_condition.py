"""A condition on a text."""

from launch.condition import Condition
from launch.conditions.evaluate_condition_expression_impl import evaluate_condition_expression
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType


class UnlessCondition(Condition):
    """True if a text means false."""

    def __init__(self, predicate_expression: SomeSubstitutionsType):
        self._expression = predicate_expression
        super().__init__(predicate=self._decide)

    def _decide(self, context: LaunchContext) -> bool:
        return not evaluate_condition_expression(context, self._expression)
