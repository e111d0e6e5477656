"""Which of its arguments a function of the learner's changes: then later calls do not get what the tests have given."""

import inspect
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from helpers.runner import values

_CAN_CHANGE = (list, dict, set, bytearray, deque)


@dataclass(frozen=True)
class Changed:
    """One argument that a call has changed; not `given`: it is the default."""

    function: str
    argument: str
    given: bool

    def __str__(self) -> str:
        if self.given:
            return f'`{self.function}` changes its argument `{self.argument}`: work with a copy.'
        return (
            f'`{self.function}` changes its default argument `{self.argument}`, which is the same object in all calls.'
        )


class Arguments:
    """The lists and dictionaries that a call gets, and those that are its defaults, as they are before it."""

    def __init__(self, function: Callable, args: list, kwargs: dict):
        given, defaults = _named(function, args, kwargs)
        self._before = [
            (kind, name, value, _written(value))
            for kind, arguments in (('given', given), ('default', defaults))
            for name, value in arguments.items()
            if isinstance(value, _CAN_CHANGE)
        ]

    def changed(self, kind: str) -> list[str]:
        """The names of the arguments of this kind, 'given' or 'default', that are other ones now."""
        return [name for its, name, value, before in self._before if its == kind and _written(value) != before]


def _named(function: Callable, args: list, kwargs: dict) -> tuple[dict, dict]:
    """What is given and what is a default, by parameter; empty if it does not fit, as the call itself will tell."""
    try:
        bound = inspect.signature(function).bind(*args, **kwargs)
    except (TypeError, ValueError):
        return {}, {}
    given = dict(bound.arguments)
    bound.apply_defaults()
    return given, {name: value for name, value in bound.arguments.items() if name not in given}


def _written(value) -> str:
    """The value as a text: as one, a number that is not equal to itself (nan) has not changed."""
    try:
        return repr(values.encode(_opened(value)))
    except (RecursionError, ValueError):  # too deep to be sent: no test has given this
        return ''


def _opened(value):
    """The value with each message's fields in its place: its bytes have gaps, with whatever stood there before."""
    if hasattr(type(value), 'get_fields_and_field_types'):
        names = type(value).get_fields_and_field_types()
        return [type(value).__name__, *(_opened(getattr(value, name)) for name in names)]
    if isinstance(value, (list, tuple, deque)):
        return [_opened(item) for item in value]
    if isinstance(value, dict):
        return {key: _opened(item) for key, item in value.items()}
    return value
