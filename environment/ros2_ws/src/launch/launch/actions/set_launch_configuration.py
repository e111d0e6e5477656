"""Sets a launch configuration."""

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


@expose_action('let')
class SetLaunchConfiguration(Action):
    """Sets a launch configuration."""

    def __init__(self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.name, self.value = (normalize_to_list_of_substitutions(text) for text in (name, value))

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``let``."""
        _, kwargs = super().parse(entity, parser)
        for attribute in ('name', 'value'):
            kwargs[attribute] = parser.parse_substitution(entity.get_attr(attribute))
        return cls, kwargs

    def describe(self) -> str:
        return f'SetLaunchConfiguration({describe_substitutions(self.name)}, {describe_substitutions(self.value)})'

    def execute(self, context: LaunchContext) -> None:
        name = perform_substitutions(context, self.name)
        context.launch_configurations[name] = perform_substitutions(context, self.value)
