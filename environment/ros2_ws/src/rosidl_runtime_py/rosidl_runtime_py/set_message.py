"""Fill a message from a dictionary, as the values on a `ros2` command line are."""

import array
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy
from rosidl_parser.definition import AbstractNestedType, NamespacedType

from rosidl_runtime_py.convert import get_message_slot_types
from rosidl_runtime_py.import_message import import_message_from_namespaced_type

_HEADER = NamespacedType(['std_msgs', 'msg'], 'Header')
_TIME = NamespacedType(['builtin_interfaces', 'msg'], 'Time')


def set_message_fields(
    msg: Any, values: dict[str, Any], expand_header_auto: bool = False, expand_time_now: bool = False
) -> list[Callable[[Any], None]]:
    """
    Set fields of a message in place; the ones not named keep their defaults.

    A value may also be a message, where the field holds one.

    :param expand_header_auto: `auto` as the value of a std_msgs/Header means a stamp to be set later.
    :param expand_time_now: `now` as the value of a builtin_interfaces/Time means the same.
    :return: functions to call with a builtin_interfaces/Time before each publishing, one per such stamp.
    :raises AttributeError: if the message has no field of a given name.
    :raises TypeError: if a value is of the wrong kind.
    :raises ValueError: if a value cannot be converted.
    """
    if not isinstance(values, dict):
        raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {type(values).__name__}")
    slot_types = get_message_slot_types(msg)
    stamps: list[Callable[[Any], None]] = []

    def nested(kind: type, content: Any) -> Any:
        if isinstance(content, kind):  # a message already
            return content
        target = kind()
        stamps.extend(set_message_fields(target, content, expand_header_auto, expand_time_now))
        return target

    for name, content in values.items():
        if not isinstance(name, str):
            raise TypeError(f"Field name '{name}' is expected to be a string but is a {type(name).__name__}")
        field = getattr(msg, name)
        slot_type = slot_types.get(name)
        if expand_header_auto and slot_type == _HEADER and content == 'auto':
            stamps.append(partial(setattr, field, 'stamp'))
        elif expand_time_now and slot_type == _TIME and content == 'now':
            stamps.append(partial(setattr, msg, name))
        elif isinstance(slot_type, NamespacedType):
            setattr(msg, name, nested(type(field), content))
        elif isinstance(slot_type, AbstractNestedType) and isinstance(slot_type.value_type, NamespacedType):
            if not isinstance(content, (list, tuple)):
                raise TypeError(f"Value '{content}' is expected to be a list but is a {type(content).__name__}")
            element = import_message_from_namespaced_type(slot_type.value_type)
            setattr(msg, name, [nested(element, item) for item in content])
        else:
            setattr(msg, name, _converted(field, content))
    return stamps


def _converted(field: Any, content: Any) -> Any:
    """Return the value as the type the field holds by default."""
    if isinstance(field, array.array):
        return array.array(field.typecode, content)
    if isinstance(field, numpy.ndarray):
        return numpy.array(content, dtype=field.dtype)
    if type(content) is type(field):
        return content
    if isinstance(field, bytes) and isinstance(content, int):
        return bytes([content])
    return type(field)(content)
