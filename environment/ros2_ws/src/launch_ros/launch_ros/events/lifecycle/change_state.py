"""The wish that lifecycle nodes change their state."""

from collections.abc import Callable

from launch.event import Event
from lifecycle_msgs.msg import State, Transition


def _constants(kind: type, *prefixes: str) -> dict[int, str]:
    """Return the names of a message's constants, by their values."""
    metaclass = type(kind)
    names = [name for name in dir(metaclass) if name.startswith(prefixes)]
    return {getattr(kind, name): name for name in names}


class ChangeState(Event):
    """
    The lifecycle nodes that a function accepts are to change their state.

    :param lifecycle_node_matcher: says for a LifecycleNode action whether it is meant
    :param transition_id: one of lifecycle_msgs/msg/Transition's TRANSITION_…
    :raises ValueError: if it is none of them
    """

    name = 'launch_ros.events.lifecycle.ChangeState'

    valid_states = _constants(State, 'PRIMARY_STATE_', 'TRANSITION_STATE_')
    valid_transitions = _constants(Transition, 'TRANSITION_')

    def __init__(self, *, lifecycle_node_matcher: Callable, transition_id: int):
        if transition_id not in self.valid_transitions:
            raise ValueError(
                f'{transition_id!r} is not the number of a transition: use one of '
                'lifecycle_msgs.msg.Transition, such as Transition.TRANSITION_CONFIGURE'
            )
        self.lifecycle_node_matcher, self.transition_id = lifecycle_node_matcher, transition_id
