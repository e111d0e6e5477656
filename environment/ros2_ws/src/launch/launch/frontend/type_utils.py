"""Types of attributes."""

from typing import Any, get_args, get_origin

from launch.frontend.entity import Entity


def check_is_list_entity(data_type: Any) -> bool:
    """Return True for ``List[Entity]``."""
    arguments = get_args(data_type)
    return get_origin(data_type) is list and isinstance(arguments[0], type) and issubclass(arguments[0], Entity)
