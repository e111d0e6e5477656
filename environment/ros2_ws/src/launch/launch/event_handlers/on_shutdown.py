"""The launched system ends."""

from launch.event_handler import EventHandler
from launch.events import Shutdown


class OnShutdown(EventHandler):
    """
    The launched system ends.

    :param on_shutdown: actions, or a function of (event, context) that returns some
    """

    def __init__(self, *, on_shutdown, **kwargs):
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), entities=on_shutdown, **kwargs)
