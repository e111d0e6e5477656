"""Names and types of actions."""

import sys
from argparse import Namespace
from typing import Any

from ros2cli.deferred import attributes_from

__getattr__ = attributes_from({'NodeStrategy': 'ros2cli.node.strategy'}, module=__name__)

# The completers look names up here, so that a test can put something else in their place, as with upstream's modules.
_this = sys.modules[__name__]


def get_action_names_and_types(*, node: Any) -> list[tuple[str, list[str]]]:
    """Return the actions of the graph with their types; `node` is a ros2cli DirectNode."""
    return node.get_action_names_and_types()


def get_action_names(*, node: Any) -> list[str]:
    """Return the actions of the graph."""
    return [name for name, _ in get_action_names_and_types(node=node)]


def get_action_clients_and_servers(*, node: Any, action_name: str) -> tuple[list, list]:
    """
    Return which nodes use and which offer an action, each as (full node name, types).

    :raises RuntimeError: if the action's name is not valid.
    """
    from rclpy.exceptions import InvalidTopicNameException
    from rclpy.expand_topic_name import expand_topic_name
    from rclpy.validate_full_topic_name import validate_full_topic_name

    try:
        full_name = expand_topic_name(action_name, node.get_name(), node.get_namespace())
        validate_full_topic_name(full_name)
    except (ValueError, InvalidTopicNameException) as e:
        raise RuntimeError(str(e)) from None
    clients, servers = [], []
    for name, namespace in node.get_node_names_and_namespaces():
        node_name = f'{namespace.rstrip("/")}/{name}'
        for found, actions in (
            (clients, node.get_action_client_names_and_types_by_node(name, namespace)),
            (servers, node.get_action_server_names_and_types_by_node(name, namespace)),
        ):
            found.extend((node_name, types) for action, types in actions if action == full_name)
    return clients, servers


def load_action_class(name: str) -> Any:
    """
    Return an action class.

    :raises RuntimeError: if there is none of that name.
    """
    from rosidl_runtime_py.utilities import get_action

    try:
        return get_action(name)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError('The passed action type is invalid') from None


def action_name_completer(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    """Return the names of the actions of the graph."""
    with _this.NodeStrategy(parsed_args) as node:
        return get_action_names(node=node)


def action_type_completer(**_: Any) -> list[str]:
    """Return all action types."""
    from rosidl_runtime_py import get_action_interfaces

    return [f'{package}/{name}' for package, names in sorted(get_action_interfaces().items()) for name in names]


class ActionTypeCompleter:
    """Completes the type of an action: the one it has; any, without the name of an action."""

    def __init__(self, *, action_name_key: str | None = None) -> None:
        """Remember which argument names the action."""
        self.action_name_key = action_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the types."""
        if self.action_name_key is None:
            return action_type_completer()
        with _this.NodeStrategy(parsed_args) as node:
            return dict(get_action_names_and_types(node=node)).get(getattr(parsed_args, self.action_name_key), [])


class ActionGoalPrototypeCompleter:
    """Completes the values of a goal: its fields with their defaults."""

    def __init__(self, *, action_type_key: str) -> None:
        """Remember which argument names the type."""
        self.action_type_key = action_type_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return one text, the YAML of a goal with default values."""
        from ros2cli.yaml_completion import quoted_yaml
        from rosidl_runtime_py import message_to_yaml

        action_class = load_action_class(getattr(parsed_args, self.action_type_key))
        return quoted_yaml(message_to_yaml(action_class.Goal()), prefix)
