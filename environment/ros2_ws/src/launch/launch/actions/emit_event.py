"""Emits an event."""

from __future__ import annotations

from launch.action import Action
from launch.event import Event
from launch.launch_context import LaunchContext


class EmitEvent(Action):
    """Emits an event."""

    def __init__(self, *, event: Event, **kwargs):
        super().__init__(**kwargs)
        if not isinstance(event, Event):
            raise RuntimeError(f'EmitEvent() expected an event instance, got {event!r}')
        self.event = event

    def describe(self) -> str:
        return f"EmitEvent(event='{self.event.name}')"

    def execute(self, context: LaunchContext) -> None:
        context.emit_event_sync(self.event)
