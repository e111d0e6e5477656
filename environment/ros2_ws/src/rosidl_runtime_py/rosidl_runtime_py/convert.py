"""Turn a message into a dictionary, YAML or CSV, as `ros2 topic echo` prints it."""

import array
import sys
from collections import OrderedDict
from typing import Any

import numpy
import yaml
from rosidl_parser import definition

_SEQUENCES = (list, tuple, array.array, numpy.ndarray)


class _Dumper(yaml.Dumper):
    """A YAML dumper that keeps the order of the fields."""


_Dumper.add_representer(
    OrderedDict, lambda dumper, data: dumper.represent_mapping('tag:yaml.org,2002:map', data.items(), flow_style=False)
)


def get_message_slot_types(msg: Any) -> 'OrderedDict[str, Any]':
    """Return the fields of a message, each with rosidl's description of its type."""
    return OrderedDict(zip(msg.get_fields_and_field_types(), msg.SLOT_TYPES, strict=True))


def message_to_yaml(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
    flow_style: bool = False,
) -> str:
    """
    Return the message as YAML, one field a line; with `flow_style` a list stands on one line.

    :param truncate_length: keep only so many elements of arrays, bytes and strings, then `...`.
    :param no_arr: name type and length of arrays instead of their elements.
    :param no_str: name the length of strings instead of their text.
    """
    fields = message_to_ordereddict(msg, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    return dump_yaml(fields, flow_style)


def dump_yaml(fields: 'OrderedDict[str, Any]', flow_style: bool = False) -> str:
    """Return what message_to_ordereddict returns as YAML; with `flow_style` a list stands on one line."""
    return yaml.dump(fields, Dumper=_Dumper, allow_unicode=True, width=sys.maxsize, default_flow_style=flow_style)


def message_to_ordereddict(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> 'OrderedDict[str, Any]':
    """Return the message as a dictionary of plain Python values in the order of its fields; see message_to_yaml."""
    return OrderedDict(
        (name, _plain(getattr(msg, name), field_type, truncate_length, no_arr, no_str))
        for name, field_type in get_message_slot_types(msg).items()
    )


def message_to_csv(msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False) -> str:
    """Return all values of the message, nested ones too, separated by commas; see message_to_yaml."""
    return ','.join(
        _csv(getattr(msg, name), field_type, truncate_length, no_arr, no_str)
        for name, field_type in get_message_slot_types(msg).items()
    )


def _plain(value: Any, field_type: Any, truncate_length: int | None, no_arr: bool, no_str: bool) -> Any:
    if isinstance(value, bytes):
        return _shortened(value.decode('latin-1'), truncate_length)
    if isinstance(value, str):
        return _length_of(value) if no_str else _shortened(value, truncate_length)
    if isinstance(value, _SEQUENCES):
        if no_arr and field_type is not None:
            return _abbreviated(value, field_type)
        kind = tuple if isinstance(value, tuple) else list
        items = [_plain(item, None, truncate_length, no_arr, no_str) for item in value[:truncate_length]]
        return kind(items + ['...'] if len(items) < len(value) else items)
    if isinstance(value, dict):
        return type(value)((key, _plain(item, None, truncate_length, no_arr, no_str)) for key, item in value.items())
    if isinstance(value, numpy.generic):
        return value.item()
    if isinstance(value, (bool, int, float)):
        return value
    return message_to_ordereddict(value, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)


def _csv(value: Any, field_type: Any, truncate_length: int | None, no_arr: bool, no_str: bool) -> str:
    if isinstance(value, _SEQUENCES):
        if no_arr and field_type is not None:
            return _abbreviated(value, field_type)
        items = [_csv(item, None, truncate_length, no_arr, no_str) for item in value[:truncate_length]]
        return ','.join(items + ['...'] if len(items) < len(value) else items)
    if isinstance(value, str):
        return _length_of(value) if no_str else _shortened(value, truncate_length)
    if isinstance(value, bytes):
        return str(_shortened(value, truncate_length))
    if isinstance(value, (bool, int, float, numpy.generic)):
        return str(value)
    return message_to_csv(value, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)


def _length_of(text: str) -> str:
    return f'<string length: <{len(text)}>>'


def _shortened(value: Any, truncate_length: int | None) -> Any:
    if truncate_length is None or len(value) <= truncate_length:
        return value
    return value[:truncate_length] + (b'...' if isinstance(value, bytes) else '...')


def _abbreviated(value: Any, field_type: Any) -> str:
    name = _type_name(field_type.value_type)
    if isinstance(field_type, definition.Array):
        return f'<array type: {name}[{field_type.size}]>'
    if isinstance(field_type, definition.BoundedSequence):
        return f'<sequence type: {name}[{field_type.maximum_size}], length: {len(value)}>'
    return f'<sequence type: {name}, length: {len(value)}>'


def _type_name(value_type: Any) -> str:
    if isinstance(value_type, definition.BasicType):
        return value_type.typename
    if isinstance(value_type, definition.AbstractString):
        return 'string'
    if isinstance(value_type, definition.AbstractWString):
        return 'wstring'
    if isinstance(value_type, definition.NamespacedType):
        return '/'.join(value_type.namespaced_name())
    return getattr(value_type, 'name', 'unknown')
