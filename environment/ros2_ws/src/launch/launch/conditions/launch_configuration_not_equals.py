"""A condition on a launch configuration."""

from launch.conditions.launch_configuration_equals import LaunchConfigurationEquals
from launch.launch_context import LaunchContext


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """True if a launch configuration does not have a value."""

    def _decide(self, context: LaunchContext) -> bool:
        return not super()._decide(context)
