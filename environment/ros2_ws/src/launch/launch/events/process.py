"""Events of processes."""

from __future__ import annotations

import signal
from collections.abc import Callable

from launch.event import Event


class RunningProcessEvent(Event):
    """Something happened to a process."""

    name = 'launch.events.process.RunningProcessEvent'

    def __init__(self, *, action, name: str, cmd: list[str], cwd: str | None, env: dict | None, pid: int):
        self.action, self.process_name, self.cmd, self.cwd, self.env, self.pid = action, name, cmd, cwd, env, pid

    @property
    def execute_process_action(self):
        """The action that started the process."""
        return self.action


class ProcessStarted(RunningProcessEvent):
    """A process runs."""

    name = 'launch.events.process.ProcessStarted'


class ProcessExited(RunningProcessEvent):
    """A process has ended."""

    name = 'launch.events.process.ProcessExited'

    def __init__(self, *, returncode: int, **process):
        super().__init__(**process)
        self.returncode = returncode


class ProcessIO(RunningProcessEvent):
    """A process has written something."""

    name = 'launch.events.process.ProcessIO'
    from_stdout = from_stderr = from_stdin = False

    def __init__(self, *, text: bytes, **process):
        super().__init__(**process)
        self.text = text


class ProcessStdout(ProcessIO):
    """A process has written to its standard output."""

    name = 'launch.events.process.ProcessStdout'
    from_stdout = True


class ProcessStderr(ProcessIO):
    """A process has written to its standard error."""

    name = 'launch.events.process.ProcessStderr'
    from_stderr = True


class ProcessTargetedEvent(Event):
    """Something is wanted of the processes that ``process_matcher`` accepts."""

    name = 'launch.events.process.ProcessTargetedEvent'

    def __init__(self, *, process_matcher: Callable[[object], bool]):
        self.process_matcher = process_matcher


class ShutdownProcess(ProcessTargetedEvent):
    """Processes are to end."""

    name = 'launch.events.process.ShutdownProcess'


class SignalProcess(ProcessTargetedEvent):
    """Processes are to get a signal."""

    name = 'launch.events.process.SignalProcess'

    def __init__(self, *, signal_number: str | int, process_matcher: Callable[[object], bool]):
        super().__init__(process_matcher=process_matcher)
        self.signal = signal.Signals[signal_number] if isinstance(signal_number, str) else signal.Signals(signal_number)
        self.signal_name = self.signal.name


def matches_action(action) -> Callable[[object], bool]:
    """Return a matcher for the process of one action."""
    return lambda other: other is action
