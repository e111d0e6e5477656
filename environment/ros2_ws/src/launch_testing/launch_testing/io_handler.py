"""
What processes have written so far.

A test that fails shows the message alone: PYTEST_DONT_REWRITE.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator

from launch.actions import ExecuteProcess
from launch.events.process import ProcessIO

from launch_testing.asserts.assert_output import assertInStream
from launch_testing.util import NoMatchingProcessException, resolveProcesses


class IoHandler:
    """The output of all processes in the order of time, and of each: by its action or its name."""

    def __init__(self):
        self._all: list[ProcessIO] = []
        self._by_name: dict[str, list[ProcessIO]] = {}

    def append(self, process_io: ProcessIO) -> None:
        """Add what a process has written."""
        self._all.append(process_io)
        self._by_name.setdefault(process_io.process_name, []).append(process_io)

    def track(self, process_name: str) -> None:
        """Know a process that has not written anything yet."""
        self._by_name.setdefault(process_name, [])

    def __iter__(self) -> Iterator[ProcessIO]:
        return iter(list(self._all))

    def processes(self) -> list[ExecuteProcess]:
        """Return the actions of the processes that have written something."""
        return [parts[0].action for parts in self._by_name.values() if parts]

    def process_names(self) -> list[str]:
        """Return the names of the processes that have written something or are tracked."""
        return list(self._by_name)

    def __getitem__(self, key: str | ExecuteProcess) -> list[ProcessIO]:
        return list(self._by_name[key if isinstance(key, str) else key.process_details['name']])


class ActiveIoHandler:
    """The same while processes still write: one can wait for an output."""

    def __init__(self):
        self._changed = threading.Condition()
        self._io_handler = IoHandler()

    @property
    def io_event(self) -> threading.Condition:
        """Notified at each output."""
        return self._changed

    def append(self, process_io: ProcessIO) -> None:
        """Add what a process has written."""
        with self._changed:
            self._io_handler.append(process_io)
            self._changed.notify_all()

    def track(self, process_name: str) -> None:
        """Know a process that has not written anything yet."""
        with self._changed:
            self._io_handler.track(process_name)

    def __iter__(self) -> Iterator[ProcessIO]:
        with self._changed:
            return iter(self._io_handler)

    def processes(self) -> list[ExecuteProcess]:
        """Return the actions of the processes that have written something."""
        with self._changed:
            return self._io_handler.processes()

    def process_names(self) -> list[str]:
        """Return the names of the processes that have written something or are tracked."""
        with self._changed:
            return self._io_handler.process_names()

    def __getitem__(self, key: str | ExecuteProcess) -> list[ProcessIO]:
        with self._changed:
            return self._io_handler[key]

    def assertWaitFor(self, *args, **kwargs) -> None:
        """
        Wait for an output, see ``waitFor``.

        :raises AssertionError: if it does not come in time
        """
        assert self.waitFor(*args, **kwargs), 'Waiting for output timed out'

    def waitFor(
        self,
        expected_output,
        process=None,
        cmd_args=None,
        *,
        strict_proc_matching: bool = True,
        output_filter=None,
        timeout: float = 10,
        strip_ansi_escape_sequences: bool = True,
        stream: str = 'stderr',
    ) -> bool:
        """
        Wait for an output, of any process if none is given; return False if it has not come in time.

        The arguments are those of ``launch_testing.asserts.assertInStream``.

        :param timeout: seconds
        :raises RuntimeError: if no such process has written anything
        """

        def is_there() -> bool:
            try:
                assertInStream(
                    self._io_handler,
                    expected_output,
                    process,
                    cmd_args,
                    output_filter=output_filter,
                    strict_proc_matching=strict_proc_matching,
                    strip_ansi_escape_sequences=strip_ansi_escape_sequences,
                    stream=stream,
                )
            except (NoMatchingProcessException, AssertionError):
                return False
            return True

        with self._changed:
            found = self._changed.wait_for(is_there, timeout)
        if not found:
            try:
                resolveProcesses(self, process=process, cmd_args=cmd_args, strict_proc_matching=False)
            except NoMatchingProcessException as error:
                raise RuntimeError(
                    f"After timeout, found no processes matching '{process}'  "
                    "It either doesn't exist, was never launched, or didn't generate any output"
                ) from error
        return found
