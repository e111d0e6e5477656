"""A remapping for all nodes that follow."""

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text

REMAPPINGS = 'ros_remaps'


@expose_action('set_remap')
class SetRemap(Action):
    """Renames a topic or service of all nodes that follow, to the end of the GroupAction around it."""

    def __init__(self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.src, self.dst = src, dst

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``set_remap``."""
        _, kwargs = super().parse(entity, parser)
        kwargs['src'] = parser.parse_substitution(entity.get_attr('from'))
        kwargs['dst'] = parser.parse_substitution(entity.get_attr('to'))
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        old = context.launch_configurations.get(REMAPPINGS, [])
        context.launch_configurations[REMAPPINGS] = [*old, (to_text(context, self.src), to_text(context, self.dst))]
