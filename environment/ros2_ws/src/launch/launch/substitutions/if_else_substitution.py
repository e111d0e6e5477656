"""One of two texts."""

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.substitutions.boolean_substitution import decide
from launch.utilities import describe_substitutions, to_text


@expose_substitution('if')
class IfElseSubstitution(Substitution):
    """One of two texts; at least one of them has to be given."""

    def __init__(
        self,
        condition: SomeSubstitutionsType,
        if_value: SomeSubstitutionsType = '',
        else_value: SomeSubstitutionsType = '',
    ):
        if if_value == else_value == '':
            raise RuntimeError('One of if_value and else_value must be specified')
        self._condition, self._if, self._else = condition, if_value, else_value

    @classmethod
    def parse(cls, data):
        """Read ``$(if condition if_value [else_value])``."""
        condition, if_value, *else_value = counted('if', data, 2, 3)
        return cls, {'condition': condition, 'if_value': if_value, 'else_value': else_value[0] if else_value else ''}

    def describe(self) -> str:
        return (
            f'IfElseSubstitution({describe_substitutions(self._condition)}, {describe_substitutions(self._if)}, '
            f'{describe_substitutions(self._else)})'
        )

    def perform(self, context: LaunchContext) -> str:
        return to_text(context, self._if if decide(context, self._condition) else self._else)
