"""The end of an action."""

from launch.event import Event


class ExecutionComplete(Event):
    """
    An action has been executed.

    For an action that goes on, such as a process, this is when it has ended.
    """

    name = 'launch.events.ExecutionComplete'

    def __init__(self, *, action):
        self.action = action
