"""Managed nodes and the calls to them."""

from collections.abc import Iterable
from typing import Any

from ros2node.api import NodeName
from ros2node.api import get_node_names as get_all_node_names
from ros2service.api import get_service_names_and_types

# Seconds that a node has to answer.
TIMEOUT = 5.0


def get_node_names(*, node: Any, include_hidden_nodes: bool = False) -> list[NodeName]:
    """Return the managed nodes: those that offer the service get_state."""
    services = dict(get_service_names_and_types(node=node, include_hidden_services=True))
    return [
        name
        for name in get_all_node_names(node=node, include_hidden_nodes=include_hidden_nodes)
        if 'lifecycle_msgs/srv/GetState' in services.get(f'{name.full_name}/get_state', ())
    ]


def call(node: Any, service_class: Any, name: str, request: Any | None = None) -> Any:
    """
    Call a service and return its response.

    :raises TimeoutError: if it does not answer.
    """
    client = node.create_client(service_class, name)
    try:
        if not node.spin(until=client.service_is_ready, timeout=TIMEOUT):
            raise TimeoutError(f'service {name} is not available')
        return node.wait_for(client.call_async(request or service_class.Request()), timeout=TIMEOUT)
    finally:
        node.destroy_client(client)


def call_get_states(*, node: Any, node_names: Iterable[str]) -> dict[str, Any]:
    """Return the state of each node, a lifecycle_msgs/State, or a TimeoutError in its place."""
    from lifecycle_msgs.srv import GetState

    return {name: _answer(node, GetState, f'{name}/get_state', 'current_state') for name in node_names}


def call_get_available_transitions(*, node: Any, states: dict[str, Any]) -> dict[str, Any]:
    """
    Return the transitions of each node from its current state, or a TimeoutError in their place.

    :param states: a state for each node: only transitions from there; None: all that the node says.
    """
    return _transitions(node, states, 'get_available_transitions')


def call_get_transition_graph(*, node: Any, states: dict[str, Any]) -> dict[str, Any]:
    """Return the transitions of each node from all states; otherwise as above."""
    return _transitions(node, states, 'get_transition_graph')


def _transitions(node: Any, states: dict[str, Any], service: str) -> dict[str, Any]:
    from lifecycle_msgs.srv import GetAvailableTransitions

    found = {}
    for name, state in states.items():
        answer = _answer(node, GetAvailableTransitions, f'{name}/{service}', 'available_transitions')
        if state is not None and not isinstance(answer, TimeoutError):
            answer = [each for each in answer if each.start_state == state]
        found[name] = answer
    return found


def call_change_states(*, node: Any, transitions: dict[str, Any]) -> dict[str, Any]:
    """Ask each node for a transition; return whether it succeeded, or a TimeoutError in its place."""
    from lifecycle_msgs.srv import ChangeState

    return {
        name: _answer(node, ChangeState, f'{name}/change_state', 'success', ChangeState.Request(transition=transition))
        for name, transition in transitions.items()
    }


def _answer(node: Any, service_class: Any, service: str, field: str, request: Any | None = None) -> Any:
    try:
        return getattr(call(node, service_class, service, request), field)
    except TimeoutError as e:
        return e
