"""Names and types of services."""

import sys
from argparse import Namespace
from typing import Any

from ros2cli.deferred import attributes_from

__getattr__ = attributes_from({'NodeStrategy': 'ros2cli.node.strategy'}, module=__name__)

# The completers look names up here, so that a test can put something else in their place, as with upstream's modules.
_this = sys.modules[__name__]


def get_service_names_and_types(*, node: Any, include_hidden_services: bool = False) -> list[tuple[str, list[str]]]:
    """Return the services of the graph with their types, hidden ones only if asked for, none of the node itself."""
    from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

    own = f'{node.get_namespace().rstrip("/")}/{node.get_name()}/'
    return [
        (name, types)
        for name, types in node.get_service_names_and_types()
        if not name.startswith(own) and (include_hidden_services or not topic_or_service_is_hidden(name))
    ]


def get_service_names(*, node: Any, include_hidden_services: bool = False) -> list[str]:
    """Return the services of the graph, hidden ones only if asked for."""
    services = get_service_names_and_types(node=node, include_hidden_services=include_hidden_services)
    return [name for name, _ in services]


def get_service_class(node: Any, service: str, blocking: bool = False, include_hidden_services: bool = False) -> Any:
    """
    Return the class of a service, or None if nobody offers it.

    :param node: a ros2cli DirectNode.
    :param blocking: wait until somebody does.
    :raises RuntimeError: if the service has several types, or one that is not installed.
    """
    from rclpy.expand_topic_name import expand_topic_name

    full_name = expand_topic_name(service, node.get_name(), node.get_namespace())

    def types() -> list[str]:
        return dict(get_service_names_and_types(node=node, include_hidden_services=include_hidden_services)).get(
            full_name, []
        )

    if blocking:
        node.spin(until=types)
    found = types()
    if len(found) > 1:
        raise RuntimeError(f"Cannot echo service '{service}', as it contains more than one type: [{', '.join(found)}]")
    return load_service_class(found[0]) if found else None


def load_service_class(name: str) -> Any:
    """
    Return a service class.

    :raises RuntimeError: if there is none of that name.
    """
    from rosidl_runtime_py.import_message import import_message_from_namespaced_type
    from rosidl_runtime_py.utilities import get_namespaced_type, is_service

    try:
        service_class = import_message_from_namespaced_type(get_namespaced_type(name, 'srv'))
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError('The passed service type is invalid') from None
    if not is_service(service_class):
        raise RuntimeError('The passed type is not a service')
    return service_class


class ServiceNameCompleter:
    """Completes the names of services."""

    def __init__(self, *, include_hidden_services_key: str | None = None) -> None:
        """Remember which argument says whether hidden services count."""
        self.include_hidden_services_key = include_hidden_services_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the names."""
        key = self.include_hidden_services_key
        with _this.NodeStrategy(parsed_args) as node:
            return get_service_names(node=node, include_hidden_services=bool(key and getattr(parsed_args, key, False)))


def service_type_completer(**_: Any) -> list[str]:
    """Return all service types."""
    from rosidl_runtime_py import get_service_interfaces

    return [f'{package}/{name}' for package, names in sorted(get_service_interfaces().items()) for name in names]


class ServiceTypeCompleter:
    """Completes the type of a service: the one it has, or any."""

    def __init__(self, *, service_name_key: str | None = None) -> None:
        """Remember which argument names the service."""
        self.service_name_key = service_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the types."""
        if self.service_name_key is not None:
            with _this.NodeStrategy(parsed_args) as node:
                types = dict(get_service_names_and_types(node=node, include_hidden_services=True)).get(
                    getattr(parsed_args, self.service_name_key)
                )
            if types:
                return types
        return service_type_completer()


class ServicePrototypeCompleter:
    """Completes the values of a request: its fields with their defaults."""

    def __init__(self, *, service_type_key: str) -> None:
        """Remember which argument names the type."""
        self.service_type_key = service_type_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return one text, the YAML of a request with default values."""
        from ros2cli.yaml_completion import quoted_yaml
        from rosidl_runtime_py import message_to_yaml

        service_class = load_service_class(getattr(parsed_args, self.service_type_key))
        return quoted_yaml(message_to_yaml(service_class.Request()), prefix)
