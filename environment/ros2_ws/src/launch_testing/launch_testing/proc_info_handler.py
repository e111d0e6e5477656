"""
How processes have ended, and which have started.

A test that fails shows the message alone: PYTEST_DONT_REWRITE.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator

from launch.actions import ExecuteProcess
from launch.events.process import ProcessExited, RunningProcessEvent

from launch_testing.util import NoMatchingProcessException, resolveProcesses


class ProcInfoHandler:
    """The last event of each process, that it has started or ended: by its action, or a part of its name."""

    def __init__(self):
        self._events: dict[ExecuteProcess, RunningProcessEvent] = {}

    def append(self, process_info: RunningProcessEvent) -> None:
        """Add an event."""
        self._events[process_info.action] = process_info

    def __iter__(self) -> Iterator[RunningProcessEvent]:
        return iter(list(self._events.values()))

    def processes(self) -> list[ExecuteProcess]:
        """Return the actions of the processes."""
        return list(self._events)

    def process_names(self) -> list[str]:
        """Return the names of the processes."""
        return [action.process_details['name'] for action in self._events]

    def __getitem__(self, key: str | ExecuteProcess) -> RunningProcessEvent:
        if not isinstance(key, str):
            return self._events[key]
        for action, event in self._events.items():
            if key in action.process_details['name']:
                return event
        raise KeyError(key)


class ActiveProcInfoHandler:
    """The same while processes still start and end: one can wait for both."""

    def __init__(self):
        self._changed = threading.Condition()
        self._proc_info_handler = ProcInfoHandler()

    @property
    def proc_event(self) -> threading.Condition:
        """Notified at each event."""
        return self._changed

    def append(self, process_info: RunningProcessEvent) -> None:
        """Add an event."""
        with self._changed:
            self._proc_info_handler.append(process_info)
            self._changed.notify_all()

    def __iter__(self) -> Iterator[RunningProcessEvent]:
        with self._changed:
            return iter(self._proc_info_handler)

    def processes(self) -> list[ExecuteProcess]:
        """Return the actions of the processes."""
        with self._changed:
            return self._proc_info_handler.processes()

    def process_names(self) -> list[str]:
        """Return the names of the processes."""
        with self._changed:
            return self._proc_info_handler.process_names()

    def __getitem__(self, key: str | ExecuteProcess) -> RunningProcessEvent:
        with self._changed:
            return self._proc_info_handler[key]

    def assertWaitForShutdown(self, process, cmd_args=None, *, timeout: float = 10) -> None:
        """
        Wait for the end of a process, see ``launch_testing.util.resolveProcesses`` for which one.

        :param timeout: seconds
        :raises AssertionError: if it has not ended in time
        """
        ended = self._wait(process, cmd_args, timeout, lambda event: isinstance(event, ProcessExited))
        assert ended, f"Timed out waiting for process '{process}' to finish"

    def assertWaitForStartup(self, process, cmd_args=None, *, timeout: float = 10) -> None:
        """
        Wait for the start of a process, see ``launch_testing.util.resolveProcesses`` for which one.

        :param timeout: seconds
        :raises AssertionError: if it has not started in time
        """
        assert self._wait(process, cmd_args, timeout, lambda _: True), (
            f"Timed out waiting for process '{process}' to start"
        )

    def _wait(self, process, cmd_args, timeout: float, accepts: Callable[[RunningProcessEvent], bool]) -> bool:
        def is_so() -> bool:
            try:
                one = resolveProcesses(self._proc_info_handler, process=process, cmd_args=cmd_args)[0]
            except NoMatchingProcessException:
                return False
            return accepts(self._proc_info_handler[one])

        with self._changed:
            return self._changed.wait_for(is_so, timeout)
