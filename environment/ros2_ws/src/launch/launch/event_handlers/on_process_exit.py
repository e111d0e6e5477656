"""A process has ended."""

from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events.process import ProcessExited


class OnProcessExit(OnActionEventBase):
    """
    A process has ended.

    :param on_exit: actions, or a function of (event, context) that returns some
    """

    def __init__(self, *, target_action=None, on_exit=None, **kwargs):
        from launch.actions import ExecuteLocal

        super().__init__(
            action_matcher=target_action,
            on_event=on_exit,
            target_event_cls=ProcessExited,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )
