"""Python values as JSON and back: what may be an argument or a result of `learner.call`.

Plain JSON values pass as they are (tuples become lists, if they are no `SentAsTuple`; numpy arrays and scalars plain
numbers). That a result itself was a set, a tuple or a named tuple can be seen. ROS messages travel as their CDR bytes,
QoS profiles, times and durations by their fields. Nothing else is sent: an object of another type becomes an `Opaque`
with the type's name, so that a test can say what the function returned.
"""

import base64
import importlib
import re
from collections import deque
from collections.abc import KeysView, ValuesView
from dataclasses import dataclass
from enum import Enum

from ament_index_python import has_resource
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.time import Time

_INTERFACE = re.compile(r'([a-z][a-z0-9_]*)/msg/([A-Z][A-Za-z0-9]*)')
_MAX_DEPTH = 30


@dataclass(frozen=True, repr=False)
class Opaque:
    """A returned object that JSON cannot carry: `type` is the name of its class."""

    type: str

    def __str__(self) -> str:
        return f'an object of type {self.type}'

    __repr__ = __str__  # it stands in sentences for learners


class SetAsList(list):
    """A returned set, as a sorted list: for tests that want it to have been a list."""


class TupleAsList(list):
    """A returned tuple, as a list: for tests that want it to have been a list."""

    def __repr__(self) -> str:
        return repr(tuple(self))  # it stands in sentences for learners


class EnumAsName(str):
    """A returned member of an enumeration, as its name, which in the learner's program it does not equal."""


class EnumAsNumber(int):
    """A returned member of an enumeration that is a number: it equals that number, and has `name` besides."""

    name = ''


class SentAsTuple(tuple):
    """A tuple in an argument that has to arrive as a tuple: one can be in a set, or a key."""


class NamedTupleAsList(list):
    """A returned named tuple, as a list: it equals a tuple, and has names besides."""


def type_name(message_class) -> str:
    """'std_msgs/msg/String' for the class std_msgs.msg.String."""
    package, kind, *_ = message_class.__module__.split('.')
    return f'{package}/{kind}/{message_class.__name__}'


def encode_result(value):
    """`encode` for what a function has returned: a tuple and a named one are told from a list."""
    encoded = encode(value)
    if not isinstance(value, tuple):
        return encoded
    return {'$tuple' if type(value) is tuple else '$named': encoded}


def encode(value, depth: int = 0):
    """Make `value` a JSON value. Raises ValueError if it is nested too deeply."""
    if depth > _MAX_DEPTH:
        raise ValueError('the value is nested too deeply')
    if isinstance(value, Enum) and not isinstance(value, (str, float)):  # those are the text or number that they equal
        number = {'value': int(value)} if isinstance(value, int) else {}
        return {'$enum': str(value.name), **number}
    if value is None or isinstance(value, (bool, int, float, str)):
        # A subclass of int or str may behave differently: send the plain value.
        for plain in (bool, int, float, str):
            if isinstance(value, plain):
                return plain(value.value if isinstance(value, Enum) else value)
        return None
    if isinstance(value, (bytes, bytearray)):
        return {'$bytes': base64.b64encode(bytes(value)).decode()}
    if isinstance(value, (set, frozenset)):
        return {'$set': [encode(item, depth + 1) for item in sorted(value, key=repr)]}
    if isinstance(value, SentAsTuple):
        return {'$row': [encode(item, depth + 1) for item in value]}
    if isinstance(value, (list, tuple, deque, KeysView, ValuesView)):
        return [encode(item, depth + 1) for item in value]
    if isinstance(value, dict):
        return {'$dict': [[encode(k, depth + 1), encode(v, depth + 1)] for k, v in value.items()]}
    if isinstance(value, QoSProfile):
        return {
            '$qos': [
                value.history.value,
                value.depth,
                value.reliability.value,
                value.durability.value,
                value.liveliness.value,
                value.deadline.nanoseconds,
                value.lifespan.nanoseconds,
            ]
        }
    if isinstance(value, Duration):
        return {'$duration': value.nanoseconds}
    if isinstance(value, Time):
        return {'$time': value.nanoseconds}
    if hasattr(type(value), 'get_fields_and_field_types'):
        return {'$msg': type_name(type(value)), 'cdr': base64.b64encode(serialize_message(value)).decode()}
    if hasattr(value, 'tolist'):  # numpy arrays and scalars, array.array
        return encode(value.tolist(), depth + 1)
    return {'$opaque': type(value).__name__}


def decode(value, depth: int = 0):
    """The inverse of `encode`. Raises ValueError on anything that `encode` does not produce."""
    if depth > 2 * _MAX_DEPTH:
        raise ValueError('the value is nested too deeply')
    if isinstance(value, list):
        return [decode(item, depth + 1) for item in value]
    if not isinstance(value, dict):
        return value
    try:
        match value:
            case {'$bytes': str(data)}:
                return base64.b64decode(data)
            case {'$enum': str(name), 'value': int(number)}:
                member = EnumAsNumber(number)
                member.name = name
                return member
            case {'$enum': str(name)}:
                return EnumAsName(name)
            case {'$set': list(items)}:
                return SetAsList(decode(item, depth + 1) for item in items)
            case {'$tuple': list(items)}:
                return TupleAsList(decode(item, depth + 1) for item in items)
            case {'$row': list(items)}:
                return SentAsTuple(decode(item, depth + 1) for item in items)
            case {'$named': list(items)}:
                return NamedTupleAsList(decode(item, depth + 1) for item in items)
            case {'$dict': list(items)}:
                return {_hashable(decode(k, depth + 1)): decode(v, depth + 1) for k, v in items}
            case {'$qos': [history, size, reliability, durability, liveliness, deadline, lifespan]}:
                return QoSProfile(
                    history=HistoryPolicy(history),
                    depth=size,
                    reliability=ReliabilityPolicy(reliability),
                    durability=DurabilityPolicy(durability),
                    liveliness=LivelinessPolicy(liveliness),
                    deadline=Duration(nanoseconds=deadline),
                    lifespan=Duration(nanoseconds=lifespan),
                )
            case {'$duration': int(nanoseconds)}:
                return Duration(nanoseconds=nanoseconds)
            case {'$time': int(nanoseconds)}:
                return Time(nanoseconds=nanoseconds)
            case {'$msg': str(name), 'cdr': str(data)}:
                return deserialize_message(base64.b64decode(data), _message_class(name))
            case {'$opaque': str(name)}:
                return Opaque(name[:100])
    except Exception as error:
        raise ValueError(f'a value that cannot be read: {error}') from None
    raise ValueError('a value of an unknown kind')


def _hashable(key):
    return tuple(key) if isinstance(key, list) else key


def _message_class(name: str):
    found = _INTERFACE.fullmatch(name)
    # Only ROS packages are imported: the name may come from the learner's side.
    if not found or not has_resource('packages', found[1]):
        raise ValueError(f'{name!r} is no message type')
    return getattr(importlib.import_module(f'{found[1]}.msg'), found[2])
