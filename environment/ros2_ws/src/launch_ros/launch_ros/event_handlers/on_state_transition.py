"""A lifecycle node changes its state."""

from __future__ import annotations

from collections.abc import Callable

from launch.event import Event
from launch.event_handler import EventHandler

from launch_ros.events.lifecycle import StateTransition


class OnStateTransition(EventHandler):
    """
    A lifecycle node has gone from one state to another.

    :param target_lifecycle_node: the action of the node; None for any
    :param transition: the label of the transition, e.g. configure; None for any
    :param start_state: the label of the state before, e.g. configuring; None for any
    :param goal_state: the label of the state after, e.g. inactive; None for any
    :param matcher: a function of the event, in place of the four
    :raises RuntimeError: if there is a matcher and one of the four
    """

    def __init__(
        self,
        *,
        entities,
        target_lifecycle_node=None,
        transition: str | None = None,
        start_state: str | None = None,
        goal_state: str | None = None,
        matcher: Callable[[Event], bool] | None = None,
        **kwargs,
    ):
        self._target = target_lifecycle_node
        self._wanted = {'transition': transition, 'start_state': start_state, 'goal_state': goal_state}
        if matcher is not None and any(value is not None for value in (self._target, *self._wanted.values())):
            raise RuntimeError(
                "'matcher' and one of 'target_lifecycle_node', 'transition', 'start_state' and "
                "'goal_state' cannot be used together"
            )
        super().__init__(matcher=matcher or self._accepts, entities=entities, **kwargs)

    def _accepts(self, event: Event) -> bool:
        if not isinstance(event, StateTransition) or self._target not in (None, event.action):
            return False
        return all(wanted is None or getattr(event, name) == wanted for name, wanted in self._wanted.items())
