"""The wish that processes end."""

from launch.events.process.process_targeted_event import ProcessTargetedEvent


class ShutdownProcess(ProcessTargetedEvent):
    """Processes are to end."""

    name = 'launch.events.process.ShutdownProcess'
