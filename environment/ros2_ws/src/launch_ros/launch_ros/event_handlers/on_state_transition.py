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
    :param matcher: a function of the event, in place of the four, which then do not count
    :raises RuntimeError: if the node is no lifecycle node
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
        if not (target_lifecycle_node is None or getattr(target_lifecycle_node, 'is_lifecycle_node', False)):
            raise RuntimeError(
                'OnStateTransition requires a "LifecycleNode" action as the target, '
                'target_lifecycle_node is not a lifecycle-enabled node.'
            )
        super().__init__(matcher=matcher or self._accepts, entities=entities, **kwargs)

    def _accepts(self, event: Event) -> bool:
        if not isinstance(event, StateTransition) or self._target not in (None, event.action):
            return False
        return all(wanted is None or getattr(event, name) == wanted for name, wanted in self._wanted.items())

    @property
    def handler_description(self) -> str:
        """A word for the entities, which the description lists."""
        return '<actions>'

    @property
    def matcher_description(self) -> str:
        """The kind of event and, if only one is meant, the node."""
        if self._target is None:
            return 'event == StateTransition'
        return f'event == StateTransition and event.action == LifecycleNode({hex(id(self._target))})'
