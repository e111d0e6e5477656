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

    def __init__(
        self,
        *,
        target_action=None,
        on_stdin: Callable | None = None,
        on_stdout: Callable | None = None,
        on_stderr: Callable | None = None,
        **kwargs,
    ):
        from launch.actions import ExecuteLocal

        functions = {0: on_stdin, 1: on_stdout, 2: on_stderr}

        def handle(event: ProcessIO, _):
            function = functions[event.fd]
            return None if function is None else function(event)

        super().__init__(
            action_matcher=target_action,
            on_event=handle,
            target_event_cls=ProcessIO,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )
