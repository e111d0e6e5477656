"""Logs a text."""

import launch.logging
from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


@expose_action('log')
class LogInfo(Action):
    """Logs a text as ``[INFO] [launch.user]: …``."""

    def __init__(self, *, msg: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.msg = normalize_to_list_of_substitutions(msg)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``log``."""
        _, kwargs = super().parse(entity, parser)
        kwargs['msg'] = parser.parse_substitution(entity.get_attr('message'))
        return cls, kwargs

    def describe(self) -> str:
        return f'LogInfo({describe_substitutions(self.msg)})'

    def execute(self, context: LaunchContext) -> None:
        launch.logging.get_logger('launch.user').info(perform_substitutions(context, self.msg))
