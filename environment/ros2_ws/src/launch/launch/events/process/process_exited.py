"""The end of a process."""

from launch.events.process.running_process_event import RunningProcessEvent


class ProcessExited(RunningProcessEvent):
    """A process has ended; ``returncode`` is negative for a signal."""

    name = 'launch.events.process.ProcessExited'

    def __init__(self, *, returncode: int, **process):
        super().__init__(**process)
        self.returncode = returncode
