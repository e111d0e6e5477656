"""A condition on a launch configuration."""

from __future__ import annotations

from launch.condition import Condition
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import to_text


class LaunchConfigurationEquals(Condition):
    """True if a launch configuration has a value; an expected value of None means that it is not set."""

    def __init__(self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None):
        self._name, self._expected = launch_configuration_name, expected_value
        super().__init__(predicate=self._decide)

    def _decide(self, context: LaunchContext) -> bool:
        value = context.launch_configurations.get(self._name)
        if self._expected is None or value is None:
            return value is self._expected
        if isinstance(self._expected, (str, Substitution, list, tuple)):
            return value == to_text(context, self._expected)
        return value == self._expected
