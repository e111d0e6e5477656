"""A part of the scope of a group."""

from launch.action import Action
from launch.launch_context import LaunchContext


class PushEnvironment(Action):
    """Saves the environment: later changes last until PopEnvironment."""

    def execute(self, context: LaunchContext) -> None:
        context.push_environment()
