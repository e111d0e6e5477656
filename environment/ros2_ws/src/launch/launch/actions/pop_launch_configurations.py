"""A part of the scope of a group."""

from launch.action import Action
from launch.launch_context import LaunchContext


class PopLaunchConfigurations(Action):
    """Goes back to the launch configurations saved last."""

    def execute(self, context: LaunchContext) -> None:
        context.pop_launch_configurations()
