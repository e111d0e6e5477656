"""Types of attributes."""

from typing import Any, get_args, get_origin

from launch.frontend.entity import Entity


def check_is_list_entity(data_type: Any) -> bool:
    """Return True for ``List[Entity]``."""
    arguments = get_args(data_type)
    return get_origin(data_type) is list and isinstance(arguments[0], type) and issubclass(arguments[0], Entity)


_SCALARS = {'str': str, 'bool': bool, 'float': float, 'int': int}
_LISTS = {f'list_of_{name}': list[kind] for name, kind in _SCALARS.items()}
_TYPES: dict[str, Any] = {**_SCALARS, **_LISTS, 'yaml': None}


def get_data_type_from_identifier(type_identifier: str) -> Any:
    """
    Return the type that a launch file names: str, int, float, bool, list_of_str and so on, or yaml, which is None.

    :raises ValueError: for any other name
    """
    if type_identifier not in _TYPES:
        raise ValueError(f"Got invalid type identifier '{type_identifier}': it is none of {', '.join(_TYPES)}")
    return _TYPES[type_identifier]
