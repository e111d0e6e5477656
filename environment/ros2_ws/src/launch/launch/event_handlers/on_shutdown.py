"""The launched system ends."""

from launch.event_handler import EventHandler
from launch.events import Shutdown


class OnShutdown(EventHandler):
    """
    The launched system ends.

    :param on_shutdown: actions, or a function of (event, context) that returns some
    """

    def __init__(self, *, on_shutdown, **kwargs):
        function = on_shutdown if callable(on_shutdown) else lambda event, context: on_shutdown
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), entities=function, **kwargs)

    @property
    def handler_description(self) -> str:
        """The function; upstream shows one for actions, too, and not the actions."""
        return str(self.entities)

    @property
    def matcher_description(self) -> str:
        """The kind of event."""
        return 'event issubclass of launch.events.Shutdown'
