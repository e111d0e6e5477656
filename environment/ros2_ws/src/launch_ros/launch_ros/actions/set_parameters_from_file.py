"""Gives a parameter file to all nodes that follow."""

from pathlib import Path

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text

from launch_ros.global_parameters import add_global_parameter


@expose_action('set_parameters_from_file')
class SetParametersFromFile(Action):
    """Gives a parameter file to all nodes that follow, to the end of the GroupAction around it."""

    def __init__(self, filename: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.filename = filename

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``set_parameters_from_file``."""
        _, kwargs = super().parse(entity, parser)
        kwargs['filename'] = parser.parse_substitution(entity.get_attr('filename'))
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        add_global_parameter(context, Path(to_text(context, self.filename)))
