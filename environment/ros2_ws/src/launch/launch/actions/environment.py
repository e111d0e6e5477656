"""Change the environment of the processes that are started later."""

import os

from launch.action import Action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import describe_substitutions, to_bool, to_text


class SetEnvironmentVariable(Action):
    """Sets a variable."""

    def __init__(self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.name, self.value = name, value

    def describe(self) -> str:
        return f'{type(self).__name__}({describe_substitutions(self.name)}, {describe_substitutions(self.value)})'

    def execute(self, context: LaunchContext) -> None:
        context.environment[to_text(context, self.name)] = to_text(context, self.value)


class AppendEnvironmentVariable(SetEnvironmentVariable):
    """
    Adds to a variable that holds a list.

    :param prepend: add in front
    :param separator: what stands between the items
    """

    def __init__(self, name, value, *, prepend=False, separator: SomeSubstitutionsType = os.pathsep, **kwargs):
        super().__init__(name, value, **kwargs)
        self._prepend, self._separator = prepend, separator

    def execute(self, context: LaunchContext) -> None:
        name, value = to_text(context, self.name), to_text(context, self.value)
        old = context.environment.get(name)
        parts = [part for part in (old, value) if part is not None]
        if to_bool(context, self._prepend):
            parts.reverse()
        context.environment[name] = to_text(context, self._separator).join(parts)


class UnsetEnvironmentVariable(Action):
    """Removes a variable; harmless if it is not set."""

    def __init__(self, name: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.name = name

    def execute(self, context: LaunchContext) -> None:
        context.environment.pop(to_text(context, self.name), None)
