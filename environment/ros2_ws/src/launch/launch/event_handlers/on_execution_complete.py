"""An action has been executed, or, if it goes on as a process does, has ended."""

from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events import ExecutionComplete


class OnExecutionComplete(OnActionEventBase):
    """
    An action has been executed, or, if it goes on as a process does, has ended.

    :param on_completion: actions, or a function of (event, context) that returns some
    """

    def __init__(self, *, target_action=None, on_completion=None, **kwargs):
        from launch.action import Action

        super().__init__(
            action_matcher=target_action,
            on_event=on_completion,
            target_event_cls=ExecutionComplete,
            target_action_cls=Action,
            **kwargs,
        )
