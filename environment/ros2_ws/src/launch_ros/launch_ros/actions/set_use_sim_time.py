"""Lets nodes take their time from /clock."""

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities.type_utils import to_bool

from launch_ros.global_parameters import GlobalParameter, add_global_parameter


@expose_action('set_use_sim_time')
class SetUseSimTime(Action):
    """Lets all nodes that follow take their time from /clock, or not."""

    def __init__(self, value: bool | SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.value = value

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``set_use_sim_time``."""
        _, kwargs = super().parse(entity, parser)
        kwargs['value'] = parser.parse_if_substitutions(entity.get_attr('value', data_type=bool))
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        add_global_parameter(context, GlobalParameter('use_sim_time', to_bool(context, self.value)))
