"""A part of the scope of a group."""

from launch.action import Action
from launch.launch_context import LaunchContext


class PopEnvironment(Action):
    """Goes back to the environment saved last."""

    def execute(self, context: LaunchContext) -> None:
        context.pop_environment()
