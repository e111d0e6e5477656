"""Sets a parameter of all nodes that follow."""

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text

from launch_ros.global_parameters import GlobalParameter, add_global_parameter
from launch_ros.parameters import evaluate_parameters


@expose_action('set_parameter')
class SetParameter(Action):
    """Sets one parameter of all nodes that follow, to the end of the GroupAction around it."""

    def __init__(self, name: SomeSubstitutionsType, value, **kwargs):
        super().__init__(**kwargs)
        self.name, self.value = name, value

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``set_parameter``."""
        _, kwargs = super().parse(entity, parser)
        kwargs['name'] = parser.parse_substitution(entity.get_attr('name'))
        kwargs['value'] = parser.parse_if_substitutions(entity.get_attr('value', data_type=None))
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        for name, value in evaluate_parameters(context, {to_text(context, self.name): self.value}).items():
            add_global_parameter(context, GlobalParameter(name, value))
