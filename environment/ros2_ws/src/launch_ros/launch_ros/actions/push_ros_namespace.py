"""A namespace for the nodes that follow."""

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import describe_substitutions, to_text

from launch_ros.namespaces import join_namespace


@expose_action('push_ros_namespace')
@expose_action('push-ros-namespace')
class PushROSNamespace(Action):
    """
    Puts the nodes that follow into a namespace, below the one that is in force.

    It lasts to the end of the GroupAction around it, or else to the end of the launch.
    """

    def __init__(self, namespace: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.namespace = namespace

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``push_ros_namespace``."""
        _, kwargs = super().parse(entity, parser)
        kwargs['namespace'] = parser.parse_substitution(entity.get_attr('namespace'))
        return cls, kwargs

    def describe(self) -> str:
        return f'PushROSNamespace({describe_substitutions(self.namespace)})'

    def execute(self, context: LaunchContext) -> None:
        base = context.launch_configurations.get('ros_namespace', '')
        context.launch_configurations['ros_namespace'] = join_namespace(base, to_text(context, self.namespace))


PushRosNamespace = PushROSNamespace
