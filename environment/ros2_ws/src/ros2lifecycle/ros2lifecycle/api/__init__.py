"""Managed nodes and the calls to them."""

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


def call_get_state(*, node: Any, node_name: str) -> Any:
    """Return the current state of a node, a lifecycle_msgs/State (TimeoutError)."""
    from lifecycle_msgs.srv import GetState

    return call(node, GetState, f'{node_name}/get_state').current_state


def call_get_available_transitions(*, node: Any, node_name: str, all_states: bool = False) -> list[Any]:
    """Return the transitions from the current state, or all there are (TimeoutError)."""
    from lifecycle_msgs.srv import GetAvailableTransitions

    service = 'get_transition_graph' if all_states else 'get_available_transitions'
    return call(node, GetAvailableTransitions, f'{node_name}/{service}').available_transitions


def call_change_state(*, node: Any, node_name: str, transition: Any) -> bool:
    """Ask for a transition and return whether it succeeded (TimeoutError)."""
    from lifecycle_msgs.srv import ChangeState

    request = ChangeState.Request(transition=transition)
    return call(node, ChangeState, f'{node_name}/change_state', request).success
