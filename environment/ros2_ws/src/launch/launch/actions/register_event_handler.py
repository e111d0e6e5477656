"""Registers an event handler."""

from launch.action import Action
from launch.event_handler import EventHandler
from launch.launch_context import LaunchContext


class RegisterEventHandler(Action):
    """Lets an event handler see events from now on."""

    def __init__(self, event_handler: EventHandler, **kwargs):
        super().__init__(**kwargs)
        self.event_handler = event_handler

    def describe(self) -> str:
        return f"RegisterEventHandler('{self.event_handler}'):"

    def describe_conditional_sub_entities(self):
        description, entities = self.event_handler.describe()
        return [(description, entities)] if entities else []

    def execute(self, context: LaunchContext) -> None:
        self.event_handler.remember_locals(context)
        context.register_event_handler(self.event_handler)
