"""What a process writes to its standard error."""

from launch.events.process.process_io import ProcessIO


class ProcessStderr(ProcessIO):
    """A process has written to its standard error."""

    name = 'launch.events.process.ProcessStderr'

    def __init__(self, **process):
        super().__init__(fd=2, **process)
