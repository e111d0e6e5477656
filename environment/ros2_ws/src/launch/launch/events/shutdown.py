"""The end of the launched system."""

from launch.event import Event


class Shutdown(Event):
    """The launched system is to end."""

    name = 'launch.events.Shutdown'

    def __init__(self, *, reason: str = 'reason not given', due_to_sigint: bool = False):
        self.reason, self.due_to_sigint = reason, due_to_sigint
