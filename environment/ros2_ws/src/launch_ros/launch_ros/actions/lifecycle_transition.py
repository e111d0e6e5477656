"""Leads lifecycle nodes through some transitions."""

from __future__ import annotations

from collections.abc import Iterable

import launch.logging
from launch.action import Action
from launch.actions import EmitEvent
from launch.event import Event
from launch.event_handler import EventHandler
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import to_text
from lifecycle_msgs.msg import Transition

from launch_ros.events.lifecycle import ChangeState, StateTransition
from launch_ros.events.matchers import matches_node_name


@expose_action('lifecycle_transition')
class LifecycleTransition(Action):
    """
    Leads lifecycle nodes through transitions, one after the other; a node whose transition fails stays where it is.

    :param lifecycle_node_names: the full names of the nodes; the / in front may be left out
    :param transition_ids: numbers of transitions, see lifecycle_msgs/msg/Transition
    :raises ValueError: if one of the two is empty
    """

    def __init__(
        self,
        *,
        lifecycle_node_names: Iterable[SomeSubstitutionsType],
        transition_ids: Iterable[int | SomeSubstitutionsType],
        **kwargs,
    ):
        super().__init__(**kwargs)
        self._names, self._transitions = list(lifecycle_node_names), list(transition_ids)
        if not self._transitions:
            raise ValueError('No transition_ids provided.')
        if not self._names:
            raise ValueError('No lifecycle_node_names provided.')

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``lifecycle_transition``, with a ``lifecycle_node_name`` and a ``transition_id`` for each."""
        _, kwargs = super().parse(entity, parser)
        for tag, attribute, argument in (
            ('lifecycle_node_name', 'name', 'lifecycle_node_names'),
            ('transition_id', 'id', 'transition_ids'),
        ):
            parts = entity.get_attr(tag, data_type=list[Entity], optional=True) or []
            kwargs[argument] = [parser.parse_substitution(str(part.get_attr(attribute))) for part in parts]
            for part in parts:
                part.assert_entity_completely_parsed()
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[Action]:
        numbers = [self._number(context, transition) for transition in self._transitions]
        sequences = [_Sequence(to_text(context, name), numbers) for name in self._names]
        for sequence in sequences:
            context.register_event_handler(sequence)
        return [sequence.next_step() for sequence in sequences]

    @staticmethod
    def _number(context: LaunchContext, transition: int | SomeSubstitutionsType) -> int:
        text = str(transition) if isinstance(transition, int) else to_text(context, transition)
        try:
            return int(text)
        except ValueError:
            raise ValueError(f'expected integer for lifecycle transition, got {text}') from None


# For each transition the labels of the state that it goes through and of the one that it ends in.
_GOALS = {
    Transition.TRANSITION_CONFIGURE: ('configuring', 'inactive'),
    Transition.TRANSITION_CLEANUP: ('cleaningup', 'unconfigured'),
    Transition.TRANSITION_ACTIVATE: ('activating', 'active'),
    Transition.TRANSITION_DEACTIVATE: ('deactivating', 'inactive'),
    Transition.TRANSITION_UNCONFIGURED_SHUTDOWN: ('shuttingdown', 'finalized'),
    Transition.TRANSITION_INACTIVE_SHUTDOWN: ('shuttingdown', 'finalized'),
    Transition.TRANSITION_ACTIVE_SHUTDOWN: ('shuttingdown', 'finalized'),
}


class _Sequence(EventHandler):
    """Asks one node for the next transition when the last one has reached its goal."""

    def __init__(self, node_name: str, transitions: list[int]):
        self._node_name, self._rest = node_name, list(transitions)
        self._is_meant = matches_node_name(node_name)
        unknown = [transition for transition in transitions if transition not in _GOALS]
        if unknown:
            raise ValueError(f'{unknown[0]} is no transition that can be asked for; possible are {sorted(_GOALS)}')
        super().__init__(matcher=self._accepts, entities=self._go_on)

    def next_step(self) -> EmitEvent:
        """Return the action that asks for the transition that is due."""
        return EmitEvent(event=ChangeState(lifecycle_node_matcher=self._is_meant, transition_id=self._rest[0]))

    def _accepts(self, event: Event) -> bool:
        return isinstance(event, StateTransition) and self._is_meant(event.action)

    def _go_on(self, event: Event, context: LaunchContext) -> EmitEvent | None:
        if event.goal_state == 'errorprocessing':
            context.unregister_event_handler(self)
            launch.logging.get_logger('launch_ros.actions.lifecycle_transition').info(
                f"Stopping transitions for {self._node_name} because 'error occured during transitions'"
            )
            return None
        if (event.start_state, event.goal_state) != _GOALS[self._rest[0]]:
            return None
        self._rest.pop(0)
        if self._rest:
            return self.next_step()
        context.unregister_event_handler(self)
        return None
