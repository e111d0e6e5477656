"""Where nodes write their logs."""

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text


@expose_action('set_ros_log_dir')
class SetROSLogDir(Action):
    """Sets the directory of the logs of all nodes that follow, to the end of the GroupAction around it."""

    def __init__(self, new_log_dir: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.log_dir = new_log_dir

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``set_ros_log_dir``."""
        _, kwargs = super().parse(entity, parser)
        kwargs['new_log_dir'] = parser.parse_substitution(entity.get_attr('new_log_dir'))
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        context.environment['ROS_LOG_DIR'] = to_text(context, self.log_dir)
