"""A part of the scope of a group."""

from launch.action import Action
from launch.launch_context import LaunchContext


class ResetEnvironment(Action):
    """Goes back to the environment that the launch began with."""

    def execute(self, context: LaunchContext) -> None:
        context.reset_environment()
