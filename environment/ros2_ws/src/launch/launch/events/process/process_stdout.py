"""What a process writes to its standard output."""

from launch.events.process.process_io import ProcessIO


class ProcessStdout(ProcessIO):
    """A process has written to its standard output."""

    name = 'launch.events.process.ProcessStdout'

    def __init__(self, **process):
        super().__init__(fd=1, **process)
