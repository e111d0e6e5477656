"""A part of the scope of a group."""

from launch.action import Action
from launch.launch_context import LaunchContext


class PushLaunchConfigurations(Action):
    """Saves the launch configurations: later changes last until PopLaunchConfigurations."""

    def execute(self, context: LaunchContext) -> None:
        context.push_launch_configurations()
