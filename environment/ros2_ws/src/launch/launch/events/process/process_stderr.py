"""What a process writes to its standard error."""

from launch.events.process.process_io import ProcessIO


class ProcessStderr(ProcessIO):
    """A process has written to its standard error."""

    name = 'launch.events.process.ProcessStderr'
    from_stderr = True
