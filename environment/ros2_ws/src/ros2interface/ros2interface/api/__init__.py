"""Names of interfaces, for completion and for `ros2 interface proto`."""

from typing import Any


def type_completer(**_: Any) -> list[str]:
    """Return all interfaces by full name."""
    from rosidl_runtime_py import get_interfaces

    return [f'{package}/{name}' for package, names in sorted(get_interfaces().items()) for name in names]


def package_name_completer(**_: Any) -> list[str]:
    """Return the packages that define interfaces."""
    from rosidl_runtime_py import get_interface_packages

    return sorted(get_interface_packages())


def interface_to_yaml(identifier: str) -> str:
    """
    Return the YAML of a message, of a service's request or of an action's goal with default values.

    :raises RuntimeError: if there is no interface of that name.
    """
    from rosidl_runtime_py import message_to_yaml
    from rosidl_runtime_py.utilities import get_interface, is_action, is_service

    try:
        interface = get_interface(identifier)
    except (AttributeError, ModuleNotFoundError):
        raise RuntimeError(f"Could not find the interface '{identifier}'") from None
    except ValueError as e:
        raise RuntimeError(str(e)) from None
    if is_service(interface):
        interface = interface.Request
    elif is_action(interface):
        interface = interface.Goal
    return message_to_yaml(interface())
