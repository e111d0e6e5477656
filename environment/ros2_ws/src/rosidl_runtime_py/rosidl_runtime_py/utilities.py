"""Get the class of a message, service or action from its name, and tell the three kinds apart."""

from typing import Any

from rosidl_parser.definition import NamespacedType

from rosidl_runtime_py.import_message import import_message_from_namespaced_type


def get_namespaced_type(identifier: str, default_namespace: str = '') -> NamespacedType:
    """
    Split `package/kind/Name`; `package/Name` works if a default for the kind is given.

    :raises ValueError: if the name has too few, too many or empty parts.
    """
    parts = identifier.split('/')
    if len(parts) == 2 and default_namespace:
        parts.insert(1, default_namespace)
    if len(parts) != 3 or not all(parts):
        raise ValueError(f"The passed interface type '{identifier}' is invalid; expected <package>/<kind>/<name>")
    return NamespacedType(parts[:2], parts[2])


def is_message(interface: Any) -> bool:
    """Return whether the class is one of a message."""
    return hasattr(interface, 'get_fields_and_field_types')


def is_service(interface: Any) -> bool:
    """Return whether the class is one of a service."""
    return hasattr(interface, 'Request') and hasattr(interface, 'Response')


def is_action(interface: Any) -> bool:
    """Return whether the class is one of an action."""
    return all(hasattr(interface, part) for part in ('Goal', 'Result', 'Feedback'))


def get_interface(identifier: str) -> Any:
    """Return the class of any interface from its full name (ValueError, ModuleNotFoundError, AttributeError)."""
    return import_message_from_namespaced_type(get_namespaced_type(identifier))


def _get(identifier: str, default_namespace: str, check: Any, kind: str) -> Any:
    interface = import_message_from_namespaced_type(get_namespaced_type(identifier, default_namespace))
    if not check(interface):
        raise ValueError(f"Expected the full name of {kind}, got '{identifier}'")
    return interface


def get_message(identifier: str) -> Any:
    """Return a message class (ValueError, ModuleNotFoundError, AttributeError)."""
    return _get(identifier, 'msg', is_message, 'a message')


def get_service(identifier: str) -> Any:
    """Return a service class (ValueError, ModuleNotFoundError, AttributeError)."""
    return _get(identifier, 'srv', is_service, 'a service')


def get_action(identifier: str) -> Any:
    """Return an action class (ValueError, ModuleNotFoundError, AttributeError)."""
    return _get(identifier, 'action', is_action, 'an action')


def get_message_namespaced_type(identifier: str) -> NamespacedType:
    """Split the name of a message, `package/msg/Name` or `package/Name`; raises ValueError as get_namespaced_type."""
    return get_namespaced_type(identifier, default_namespace='msg')


def get_service_namespaced_type(identifier: str) -> NamespacedType:
    """Split the name of a service, `package/srv/Name` or `package/Name`; raises ValueError as get_namespaced_type."""
    return get_namespaced_type(identifier, default_namespace='srv')


def get_action_namespaced_type(identifier: str) -> NamespacedType:
    """Split the name of an action, `package/action/Name` or `package/Name`; raises as get_namespaced_type."""
    return get_namespaced_type(identifier, default_namespace='action')
