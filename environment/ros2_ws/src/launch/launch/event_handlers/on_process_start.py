"""A process has started."""

from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events.process import ProcessStarted


class OnProcessStart(OnActionEventBase):
    """
    A process has started.

    :param on_start: actions, or a function of (event, context) that returns some
    """

    def __init__(self, *, target_action=None, on_start=None, **kwargs):
        from launch.actions import ExecuteLocal

        super().__init__(
            action_matcher=target_action,
            on_event=on_start,
            target_event_cls=ProcessStarted,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )
