"""What a process reads and writes."""

from launch.events.process.running_process_event import RunningProcessEvent


class ProcessIO(RunningProcessEvent):
    """
    A process has written something: ``text``, the bytes as they came, whole lines or not.

    :param fd: the number of the stream: 0 is the standard input, 1 the standard output, 2 the standard error
    """

    name = 'launch.events.process.ProcessIO'

    def __init__(self, *, text: bytes, fd: int, **process):
        super().__init__(**process)
        self.text = text
        self.fd = fd

    @property
    def from_stdin(self) -> bool:
        """True for what the process has read."""
        return self.fd == 0

    @property
    def from_stdout(self) -> bool:
        """True for what it has written to its standard output."""
        return self.fd == 1

    @property
    def from_stderr(self) -> bool:
        """True for what it has written to its standard error."""
        return self.fd == 2
