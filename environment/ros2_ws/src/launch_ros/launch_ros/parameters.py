"""Parameters in launch files: from what may be written to plain values."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import to_text

from launch_ros.global_parameters import GlobalParameter
from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue, is_one_text

if TYPE_CHECKING:
    from rcl_interfaces.msg import Parameter as ParameterMessage

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
        if not items:  # nothing says of which type it is; upstream's words
            kinds = (float, int, str, bool, bytes)
            raise TypeError(f"Expected 'value' to be one of {list(kinds)}, but got '()' of type '{tuple}'")
        items = [_evaluate_item(context, name, item) for item in items]
        if {type(item) for item in items} == {int, float}:
            return [float(item) for item in items]
        return _checked_list(items)
    raise TypeError(f"parameter '{name}' has a value that no parameter can have: {value!r}")


def _evaluate_item(context: LaunchContext, name: str, item: Any) -> Any:
    """Return an item of an array; a list of texts and substitutions is one text, also without a substitution."""
    if isinstance(item, _PLAIN):
        return item
    if isinstance(item, (list, tuple)) and _is_text(item):
        return _from_yaml(name, to_text(context, list(item)))
    return _evaluate(context, name, item)


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


def parameter_messages(context: LaunchContext, items: Iterable, node: str) -> list[ParameterMessage]:
    """
    Return parameters as a service takes them; later ones win.

    :param items: as ``check_parameters`` takes them, and global parameters
    :param node: the node's full name, which says what of a parameter file is for it
    :raises OSError: if a parameter file cannot be read
    :raises TypeError: for a value that no parameter can have
    """
    from rclpy.parameter import Parameter as RclpyParameter

    values = (pair for item in items for pair in _named_values(context, item, node).items())
    return [RclpyParameter(name, value=value).to_parameter_msg() for name, value in values]


def _named_values(context: LaunchContext, item: Any, node: str) -> dict[str, Any]:
    if isinstance(item, GlobalParameter):
        return {item.name: item.value}
    if isinstance(item, Parameter):
        return dict([item.evaluate(context)])
    if isinstance(item, Mapping):
        return evaluate_parameters(context, item)
    path = item.evaluate(context) if isinstance(item, ParameterFile) else Path(to_text(context, item))
    return evaluate_parameters(context, _of_node(yaml.safe_load(path.read_text(encoding='utf-8')) or {}, node))


def _of_node(content: Mapping, node: str) -> dict[str, Any]:
    """Return what of a parameter file is for a node, in the file's order; a file without names of nodes is for all."""
    sections = list(_sections(content, ''))
    if not sections:
        return dict(content)
    found: dict[str, Any] = {}
    for name, values in sections:
        pattern = re.escape(name).replace(r'/\*\*', r'(/\w+)*').replace(r'/\*', r'/\w+')
        if re.fullmatch(pattern, node):
            found.update(values)
    return found


def _sections(content: Mapping, above: str) -> Iterator[tuple[str, Mapping]]:
    """Yield each name of a node, as the keys around ``ros__parameters`` spell it, with its parameters."""
    for key, value in content.items():
        if key == 'ros__parameters':
            yield above, value or {}
        elif isinstance(value, Mapping):
            yield from _sections(value, f'{above}/{str(key).lstrip("/")}')
