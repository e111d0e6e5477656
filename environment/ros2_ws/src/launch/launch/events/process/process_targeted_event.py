"""A wish to processes."""

from collections.abc import Callable

from launch.event import Event


class ProcessTargetedEvent(Event):
    """Something is wanted of the processes that ``process_matcher`` accepts."""

    name = 'launch.events.process.ProcessTargetedEvent'

    def __init__(self, *, process_matcher: Callable[[object], bool]):
        self.process_matcher = process_matcher
