"""A process has written."""

from __future__ import annotations

from collections.abc import Callable

from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events.process import ProcessIO


class OnProcessIO(OnActionEventBase):
    """
    A process has written something.

    The functions get the event, whose ``text`` is what was read at once, as bytes, and may return actions.

    :param on_stdin: accepted as upstream's; nothing is ever written to a process
    """

    _argument = 'on_output'

    def __init__(
        self,
        *,
        target_action=None,
        on_stdin: Callable | None = None,
        on_stdout: Callable | None = None,
        on_stderr: Callable | None = None,
        **kwargs,
    ):
        from launch.actions import ExecuteProcess

        self._functions = {0: on_stdin, 1: on_stdout, 2: on_stderr}
        super().__init__(
            action_matcher=target_action,
            on_event=self._pass_on,
            target_event_cls=ProcessIO,
            target_action_cls=ExecuteProcess,
            **kwargs,
        )

    def _pass_on(self, event: ProcessIO, context):
        function = self._functions[event.fd]
        return None if function is None else function(event)
