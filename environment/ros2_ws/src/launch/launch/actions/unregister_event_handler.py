"""Forgets an event handler."""

from launch.action import Action
from launch.event_handler import EventHandler
from launch.launch_context import LaunchContext


class UnregisterEventHandler(Action):
    """Lets an event handler see no more events."""

    def __init__(self, event_handler: EventHandler, **kwargs):
        super().__init__(**kwargs)
        self.event_handler = event_handler

    def execute(self, context: LaunchContext) -> None:
        context.unregister_event_handler(self.event_handler)
