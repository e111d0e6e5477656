"""Change launch configurations."""

from launch.action import Action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import describe_substitutions, to_text


class SetLaunchConfiguration(Action):
    """Sets a launch configuration."""

    def __init__(self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.name, self.value = name, value

    def describe(self) -> str:
        return f'SetLaunchConfiguration({describe_substitutions(self.name)}, {describe_substitutions(self.value)})'

    def execute(self, context: LaunchContext) -> None:
        context.launch_configurations[to_text(context, self.name)] = to_text(context, self.value)


class UnsetLaunchConfiguration(Action):
    """Removes a launch configuration; harmless if it is not set."""

    def __init__(self, name: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.name = name

    def execute(self, context: LaunchContext) -> None:
        context.launch_configurations.pop(to_text(context, self.name), None)
