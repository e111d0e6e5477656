"""Emits an event."""

from __future__ import annotations

import launch.logging
from launch.action import Action
from launch.event import Event
from launch.events import Shutdown as ShutdownEvent
from launch.events.process import ProcessExited
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


class Shutdown(EmitEvent):
    """Ends the launched system; as ``on_exit`` of a process it makes that process a required one."""

    def __init__(self, *, reason: str = 'reason not given', **kwargs):
        super().__init__(event=ShutdownEvent(reason=reason), **kwargs)

    def execute(self, context: LaunchContext) -> None:
        event = context.get_locals_as_dict().get('event')
        if isinstance(event, ProcessExited) and not context.is_shutdown:
            launch.logging.get_logger('launch').info(
                f'process[{event.process_name}] was required: shutting down launched system'
            )
        super().execute(context)
