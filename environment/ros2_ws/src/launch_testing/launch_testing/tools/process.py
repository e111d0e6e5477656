"""A process that a test starts while the launch runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess
from launch.events import matches_action
from launch.events.process import ProcessExited, ProcessStarted, ShutdownProcess

from launch_testing.io_handler import ActiveIoHandler
from launch_testing.proc_info_handler import ActiveProcInfoHandler


class WhetherWithOutput:
    """True or false; where it is shown, as in a failed assertion, with the output so far."""

    def __init__(self, result: bool, output: str):
        self._result, self._output = result, output

    def __bool__(self) -> bool:
        return self._result

    def __repr__(self) -> str:
        return f'<{self._result}: {self._output!r}>'


class ProcessProxy:
    """
    One process of a launch: whether it runs, what it has written, how it has ended.

    :param output_filter: applied to all outputs before they are given, as `basic_output_filter` makes one
    :raises TypeError: for arguments of other types
    """

    def __init__(
        self,
        process_action: ExecuteProcess,
        proc_info: ActiveProcInfoHandler,
        proc_output: ActiveIoHandler,
        *,
        output_filter: Callable[[str], str] | None = None,
    ):
        kinds = {ExecuteProcess: process_action, ActiveProcInfoHandler: proc_info, ActiveIoHandler: proc_output}
        for kind, value in kinds.items():
            if not isinstance(value, kind):
                raise TypeError(f"expected '{kind.__name__}', got '{value!r}'")
        if output_filter is not None and not callable(output_filter):
            raise TypeError(f"expected 'output_filter' to be callable, got '{output_filter!r}'")
        self._action, self._info, self._written = process_action, proc_info, proc_output
        self._filter = output_filter or (lambda text: text)

    @property
    def target_process_action(self) -> ExecuteProcess:
        """The action of the process."""
        return self._action

    def wait_for_shutdown(self, timeout: float | None = None) -> bool:
        """Wait for the end of the process, at most so many seconds; return whether it has ended."""
        with self._info.proc_event:
            return self._info.proc_event.wait_for(lambda: self.terminated, timeout)

    def wait_for_output(
        self, condition: Callable[[str], object] | None = None, timeout: float | None = None
    ) -> WhetherWithOutput:
        """
        Wait while the process runs until it has written what a condition asks for; return whether it has.

        :param condition: gets all that was written so far; None for any output
        :param timeout: seconds at most
        :raises TypeError: if the condition is not callable
        """
        if condition is not None and not callable(condition):
            raise TypeError(f"expected 'condition' to be callable, got '{condition!r}'")
        wanted = condition or bool
        with self._written.io_event:
            found = self._written.io_event.wait_for(lambda: self.running and bool(wanted(self.output)), timeout)
            return WhetherWithOutput(found, self.output)

    @property
    def output(self) -> str:
        """All that the process has written."""
        return self._text(lambda part: True)

    @property
    def stdout(self) -> str:
        """What it has written to its standard output."""
        return self._text(lambda part: part.from_stdout)

    @property
    def stderr(self) -> str:
        """What it has written to its standard error."""
        return self._text(lambda part: part.from_stderr)

    def _text(self, counts: Callable) -> str:
        if self._action not in self._written.processes():  # it has written nothing
            return ''
        parts = b''.join(part.text for part in self._written[self._action] if counts(part))
        return self._filter(parts.decode(errors='replace'))

    @property
    def running(self) -> bool:
        """Whether it has started, and not ended."""
        return isinstance(self._last_event(), ProcessStarted)

    @property
    def terminated(self) -> bool:
        """Whether it has ended."""
        return isinstance(self._last_event(), ProcessExited)

    def _last_event(self):
        return self._info[self._action] if self._action in self._info.processes() else None

    @property
    def exit_code(self) -> int:
        """Its exit code; it must have ended."""
        return self._info[self._action].returncode


@contextmanager
def launch_process(
    launch_service: LaunchService,
    process_action: ExecuteProcess,
    proc_info: ActiveProcInfoHandler,
    proc_output: ActiveIoHandler,
    **kwargs,
) -> Iterator[ProcessProxy]:
    """
    Start a process in a running launch, and end it with the block. Further arguments are those of `ProcessProxy`.

    :raises TypeError: for arguments of other types
    """
    process = ProcessProxy(process_action, proc_info, proc_output, **kwargs)
    launch_service.include_launch_description(LaunchDescription([process_action]))
    try:
        yield process
    finally:
        if not process.terminated:
            launch_service.emit_event(ShutdownProcess(process_matcher=matches_action(process_action)))
