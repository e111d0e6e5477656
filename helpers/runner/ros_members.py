"""What the messages, enumerations and objects of ROS have: after a misspelt field, member or method."""

import enum
import importlib
import inspect
import re
from collections.abc import Iterable
from typing import Any

from helpers.runner import imports, similar

_ENUMERATIONS = (
    *('DurabilityPolicy', 'ReliabilityPolicy', 'HistoryPolicy', 'LivelinessPolicy', 'GoalResponse', 'CancelResponse'),
    'TransitionCallbackReturn',
)
_PACKAGES = 'tf2_ros', 'message_filters'  # of ROS that offer their classes themselves; Python's modules have no dots
_NAMED_VALUES = 'Duration', 'QoSProfile', 'Time'  # classes of rclpy
_OF_FUTURES = frozenset('add_done_callback done result exception cancelled'.split())
_MOST = 12  # fields that are listed


def attribute(kind: str, name: str) -> str:
    """A sentence on `name`, which an object of the class `kind` does not have; '' if that is no class of ROS.

    :param kind: as Python says it in an AttributeError, such as 'Range' or 'SetStation_Request'.
    """
    if messages := _fields(kind):
        return _field(name, messages)
    near = similar.nearest(name, dir(_class(kind)))
    return f'A {kind} has no `{name}`; there is `{near}`.' if near else ''


def of_class(kind: str) -> frozenset[str]:
    """What belongs to the class of ROS with this name itself, such as `from_msg` to Time, and not to its objects."""
    found = _class(kind)
    return frozenset(
        name
        for name in dir(found)
        if name[0] != '_'
        and isinstance(inspect.getattr_static(found, name), classmethod | staticmethod | type | enum.Enum)
    )


def is_message(kind: str) -> bool:
    """Whether a message, or a part of a service or an action, has this name."""
    return bool(_fields(kind))


def named_values(kind: str) -> str:
    """A sentence if the values of a class of ROS are given by their names only, as those of messages; else ''."""
    named = kind in _NAMED_VALUES or is_message(kind)
    return f'Its values are given by their names: {kind}(…=…).' if named else ''


def argument(kind: str, given: Iterable[str]) -> str:
    """A sentence on the first of the arguments `given` that a class of ROS does not take; '' if there is none."""
    there = [name[1:] for name in getattr(_class(kind), '__slots__', ())]
    wrong = next((name for name in given if name not in there), '')
    if not wrong or not there:
        return ''
    near = similar.nearest(wrong, there)
    return f'{kind} has no argument `{wrong}`{f"; there is `{near}`" if near else ": it has " + ", ".join(there)}.'


def member(name: str, answer: str, kind: str = '') -> str:
    """A sentence on a member that an enumeration or a message does not have, such as DurabilityPolicy.TRANSIENTLOCAL.

    :param answer: the learner's text, in which the class stands before it if `kind` is not known.
    """
    wanted = re.search(rf'\b(\w+)\.{re.escape(name)}\b', answer) if not kind else None
    kind = wanted[1] if wanted else kind
    found = _class(kind)
    if found is None:
        return ''
    there = [one for one in dir(found) if one.isupper() and not one.startswith('_') and one != 'SLOT_TYPES']
    near = similar.nearest(name.upper(), there)
    return f'{kind} has {f"`{near}`" if near else ", ".join(there)}, and no `{name}`.' if there else ''


def enumeration_of(name: str) -> str:
    """A sentence if `name` alone is the name of a member, such as TRANSIENT_LOCAL; '' if it is none."""
    if not name.isupper():
        return ''
    kinds = [kind for kind in _ENUMERATIONS if name in getattr(_class(kind), '__members__', ())]
    written = ' or '.join(f'{kind}.{name}' for kind in kinds)
    return f'`{name}` is one of the values of {" and of ".join(kinds)}. Write: {written}' if kinds else ''


def _class(kind: str) -> Any:
    """The class of ROS with this name, the likeliest of several; None if there is none."""
    return next(iter(_classes(kind)), None)


def _classes(kind: str) -> list[Any]:
    whole, _, part = kind.partition('_')
    found = []
    for module in imports.modules_of(whole):
        one = getattr(importlib.import_module(module), whole, None)
        one = getattr(one, part, None) if part else one
        if isinstance(one, type) and ('.' in module or module in _PACKAGES):
            found.append(one)
    return found


def _fields(kind: str) -> list[tuple[str, ...]]:
    """The fields of each message with this name: there is a Pose in geometry_msgs, and another one in turtlesim."""
    messages = [one for one in _classes(kind) if hasattr(one, 'get_fields_and_field_types')]
    return sorted({tuple(one.get_fields_and_field_types()) for one in messages})


def _field(name: str, messages: list[tuple[str, ...]]) -> str:
    if name in _OF_FUTURES:
        return 'This is the message itself, and no future: the answer is there already.'
    said = f'The message has no field `{name}`'
    if near := similar.nearest(name, {field for fields in messages for field in fields}):
        return f'{said}; there is `{near}`.'
    if len(messages) > 1:
        return f'{said}: `ros2 interface show` prints the fields that it has.'
    fields = messages[0]
    names = ', '.join(fields[:_MOST]) + (' …' if len(fields) > _MOST else '')
    return f'{said}. Its fields: {names}.' if fields else f'{said}, and no other one.'
