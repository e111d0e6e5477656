"""Import the Python class of an interface that rosidl's type description names."""

import importlib
from typing import Any

from rosidl_parser.definition import NamespacedType


def import_message_from_namespaced_type(message_type: NamespacedType) -> Any:
    """
    Return the class.

    :raises ModuleNotFoundError: if the package is not installed.
    :raises AttributeError: if the package has no such interface.
    """
    module = importlib.import_module('.'.join(message_type.namespaces))
    return getattr(module, message_type.name)
