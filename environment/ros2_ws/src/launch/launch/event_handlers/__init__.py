"""Event handlers."""

from __future__ import annotations

from collections.abc import Callable

from launch.event import Event
from launch.event_handler import EventHandler
from launch.events import ExecutionComplete, Shutdown
from launch.events.process import ProcessExited, ProcessIO, ProcessStarted

__all__ = ['OnExecutionComplete', 'OnProcessExit', 'OnProcessIO', 'OnProcessStart', 'OnShutdown']


class _OnActionEvent(EventHandler):
    """An event of one kind, of one action, of those that a function accepts, or of any."""

    _kind: type[Event]
    _argument = ''

    def __init__(self, *, target_action=None, entities=None, handle_once: bool = False):
        self._target = target_action
        super().__init__(matcher=self._accepts, entities=entities, handle_once=handle_once)

    def _accepts(self, event: Event) -> bool:
        if not isinstance(event, self._kind):
            return False
        if self._target is None or event.action is self._target:
            return True
        return callable(self._target) and bool(self._target(event.action))

    def describe(self):
        text, entities = super().describe()
        entities_text = '<callable>' if callable(self._entities) else '<actions>'
        return text.replace('()', f"(matcher='{self._kind.__name__}', {self._argument}={entities_text})"), entities


class OnProcessStart(_OnActionEvent):
    """A process has started. ``on_start``: actions, or a function of (event, context) that returns some."""

    _kind, _argument = ProcessStarted, 'on_start'

    def __init__(self, *, target_action=None, on_start=None, handle_once: bool = False):
        super().__init__(target_action=target_action, entities=on_start, handle_once=handle_once)


class OnProcessExit(_OnActionEvent):
    """A process has ended. ``on_exit``: actions, or a function of (event, context) that returns some."""

    _kind, _argument = ProcessExited, 'on_exit'

    def __init__(self, *, target_action=None, on_exit=None, handle_once: bool = False):
        super().__init__(target_action=target_action, entities=on_exit, handle_once=handle_once)


class OnExecutionComplete(_OnActionEvent):
    """An action has been executed."""

    _kind, _argument = ExecutionComplete, 'on_completion'

    def __init__(self, *, target_action=None, on_completion=None, handle_once: bool = False):
        super().__init__(target_action=target_action, entities=on_completion, handle_once=handle_once)


class OnProcessIO(_OnActionEvent):
    """A process has written. The functions get the event, whose ``text`` is bytes, and may return actions."""

    _kind, _argument = ProcessIO, 'on_output'

    def __init__(
        self,
        *,
        target_action=None,
        on_stdin: Callable | None = None,
        on_stdout: Callable | None = None,
        on_stderr: Callable | None = None,
    ):
        self._on_stdout, self._on_stderr = on_stdout, on_stderr
        super().__init__(target_action=target_action, entities=self._pass_on)

    def _pass_on(self, event: ProcessIO, context):
        function = self._on_stdout if event.from_stdout else self._on_stderr
        return None if function is None else function(event)


class OnShutdown(EventHandler):
    """The launched system ends. ``on_shutdown``: actions, or a function of (event, context) that returns some."""

    def __init__(self, *, on_shutdown, handle_once: bool = False):
        super().__init__(
            matcher=lambda event: isinstance(event, Shutdown), entities=on_shutdown, handle_once=handle_once
        )
