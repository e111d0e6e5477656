"""Parameters in launch files: from what may be written to plain values."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from typing import Any

import yaml
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import to_text

from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue, is_one_text

_PLAIN = (bool, int, float, str)


def check_parameters(parameters: Iterable) -> None:
    """
    Check what a node is given as parameters, before anything is launched.

    :raises TypeError: for what is neither a dictionary nor a file, and for names and values that no parameter can have
    """
    for item in parameters:
        if isinstance(item, Mapping):
            _check_values(item)
        elif not isinstance(item, (Parameter, ParameterFile, PathLike)) and not _is_text(item):
            raise TypeError(f"'parameters' of Node takes dictionaries and paths of files, got {item!r}")


def _check_values(parameters: Mapping) -> None:
    for name, value in parameters.items():
        if not _is_text(name):
            raise TypeError(f'the name of a parameter must be a text, got {name!r}')
        if isinstance(value, Mapping):
            _check_values(value)
        elif not isinstance(value, (ParameterValue, Substitution, *_PLAIN)):
            is_array = isinstance(value, Sequence) or hasattr(value, 'tolist')  # numpy's are no sequences
            if not is_array or not all(isinstance(item, _PLAIN) or _is_text(item) for item in value):
                raise TypeError(f"parameter '{name}' has a value that no parameter can have: {value!r}")


def _is_text(value: Any) -> bool:
    """Return whether a value is a text, or has parts which together become one."""
    if isinstance(value, (list, tuple)):
        return all(isinstance(part, (str, Substitution)) for part in value)
    return isinstance(value, (str, Substitution))


def evaluate_parameters(context: LaunchContext, parameters: Mapping) -> dict[str, Any]:
    """
    Return the names and plain values of a parameter dictionary.

    A value made of substitutions is read as YAML, so that ``'5'`` becomes a number; nested dictionaries become
    names with dots.

    :raises TypeError: for a value that no parameter can have
    """
    result: dict[str, Any] = {}
    for name, value in parameters.items():
        text = to_text(context, name)
        if isinstance(value, Mapping):
            result.update({f'{text}.{key}': item for key, item in evaluate_parameters(context, value).items()})
        else:
            result[text] = _evaluate(context, text, value)
    return result


def _evaluate(context: LaunchContext, name: str, value: Any) -> Any:
    if isinstance(value, ParameterValue):
        return value.evaluate(context)
    if isinstance(value, _PLAIN):
        return value
    if isinstance(value, Substitution):
        return _from_yaml(name, to_text(context, value))
    if isinstance(value, Iterable):
        items = list(value)
        if is_one_text(items):
            return _from_yaml(name, to_text(context, items))
        items = [_evaluate(context, name, item) if not isinstance(item, _PLAIN) else item for item in items]
        if {type(item) for item in items} == {int, float}:
            return [float(item) for item in items]
        return _checked_list(items) if items else items
    raise TypeError(f"parameter '{name}' has a value that no parameter can have: {value!r}")


_AS_TEXT = (
    'If the parameter is meant to be a string, try wrapping it in '
    'launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)'
)


def _from_yaml(name: str, text: str) -> Any:
    try:
        value = yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise TypeError(f'Unable to parse the value of parameter {name} as yaml. {_AS_TEXT}') from error
    if value is None:
        return ''
    if isinstance(value, (*_PLAIN, bytes)):
        return value
    if isinstance(value, list):
        return _checked_list(value)
    raise TypeError(
        'Allowed value types are bytes, bool, int, float, str, Sequence[bool], Sequence[int], Sequence[float], '
        f'Sequence[str]. Got {type(value)}. {_AS_TEXT}'
    )


def _checked_list(items: list) -> list:
    kinds = {type(item) for item in items}
    if len(kinds) != 1 or not kinds <= set(_PLAIN):
        raise TypeError(
            'Expected a non-empty sequence, with items of uniform type. Allowed sequence item types are bool, int, '
            'float, str.'
        )
    return items
