"""What a process reads and writes."""

from launch.events.process.running_process_event import RunningProcessEvent


class ProcessIO(RunningProcessEvent):
    """A process has written something: ``text``, the bytes as they came, whole lines or not."""

    name = 'launch.events.process.ProcessIO'
    from_stdin = from_stdout = from_stderr = False

    def __init__(self, *, text: bytes, **process):
        super().__init__(**process)
        self.text = text
