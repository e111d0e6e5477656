"""Which tag of a launch file stands for which action, and which word after ``$(`` for which substitution."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable
from typing import Any

action_parse_methods: dict[str, Callable] = {}
substitution_parse_methods: dict[str, Callable] = {}


def expose_action(name: str) -> Callable:
    """
    Give an action the tag ``name``; for a class with a class method ``parse(entity, parser)``, or for such a function.

    It returns the action's class and the keyword arguments to make one.

    :raises RuntimeError: if there is no such method, or the name is taken
    """
    return functools.partial(_expose, name, action_parse_methods, 'action')


def expose_substitution(name: str) -> Callable:
    """
    Give a substitution the word ``name``; for a class with a class method ``parse(data)``, or for such a function.

    ``data`` holds one list of substitutions for each argument.

    :raises RuntimeError: if there is no such method, or the name is taken
    """
    return functools.partial(_expose, name, substitution_parse_methods, 'substitution')


def _expose(name: str, known: dict[str, Callable], kind: str, exposed: Any) -> Any:
    parse = _parse_method(name, kind, exposed)
    if kind == 'action':
        parse = _checked(parse)
    if name in known and inspect.unwrap(known[name]) != inspect.unwrap(parse):
        raise RuntimeError(f'Two {kind} parsing methods exposed with the same name: [{name}].')
    known[name] = parse
    return exposed


def _parse_method(name: str, kind: str, exposed: Any) -> Callable:
    if inspect.isclass(exposed):
        if not inspect.ismethod(getattr(exposed, 'parse', None)):
            raise RuntimeError("Did not find a class method called 'parse' in the class being decorated.")
        return exposed.parse
    if not inspect.isfunction(exposed):
        raise RuntimeError(f'Exposed {kind} parser for {name} is not a callable or a class containing a parse method')
    return exposed


def _checked(parse: Callable) -> Callable:
    @functools.wraps(parse)
    def parse_all(entity, parser):
        result = parse(entity, parser)
        entity.assert_entity_completely_parsed()
        return result

    return parse_all


def instantiate_action(entity, parser):
    """
    Make the action that an entity stands for.

    :raises RuntimeError: if its tag is not known
    """
    if entity.type_name not in action_parse_methods:
        raise RuntimeError(f'Unrecognized entity of the type: {entity.type_name}')
    kind, kwargs = action_parse_methods[entity.type_name](entity, parser)
    return kind(**kwargs)


def instantiate_substitution(type_name: str, args: Iterable | None = None):
    """
    Make a substitution from its word and arguments.

    :raises RuntimeError: if the word is not known
    """
    if type_name not in substitution_parse_methods:
        raise RuntimeError(f'Unknown substitution: {type_name}')
    kind, kwargs = substitution_parse_methods[type_name](list(args or []))
    args = kwargs.pop('args', ())  # for those that take any number of them
    return kind(*args, **kwargs)
