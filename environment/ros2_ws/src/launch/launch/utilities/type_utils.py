"""
Values with types: what an attribute of a launch file, or an argument of an action, may hold.

A type is ``int``, ``float``, ``bool``, ``str``, or a list of one of them; None stands for any of these.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Union, get_args, get_origin

import yaml

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions, perform_substitutions

ScalarTypesTuple = (int, float, bool, str)
ListTypesTuple = (list[int], list[float], list[bool], list[str])
AllowedTypesTuple = ScalarTypesTuple + ListTypesTuple

ScalarValueType = Union[int, float, bool, str]  # noqa: UP007
ListValueType = Union[list[int], list[float], list[bool], list[str]]  # noqa: UP007
AllowedTypesType = Any
AllowedValueType = Union[ScalarValueType, ListValueType]  # noqa: UP007
SomeValueType = Union[SomeSubstitutionsType, ScalarValueType, Sequence]  # noqa: UP007
NormalizedValueType = Union[list, ScalarValueType]  # noqa: UP007
StrSomeValueType = Union[ScalarValueType, Sequence]  # noqa: UP007


def is_typing_list(data_type: Any) -> bool:
    """Return True for ``List``, ``List[int]`` and the like."""
    return get_origin(data_type) is list


def extract_type(data_type: AllowedTypesType) -> tuple[type, bool]:
    """
    Return the type of one item, and whether it is a list.

    :raises ValueError: if it is no allowed type
    """
    is_list = is_typing_list(data_type)
    scalar = get_args(data_type)[0] if is_list and get_args(data_type) else data_type
    if scalar not in ScalarTypesTuple:
        raise ValueError(f'Unrecognized data type: {data_type}')
    return scalar, is_list


def is_instance_of_valid_type(value: Any, can_be_str: bool = False) -> bool:
    """
    Return True for a scalar, or a list of scalars of one type.

    :param can_be_str: a list may hold texts besides, which are substitutions still to be performed
    """
    if not isinstance(value, list):
        return isinstance(value, ScalarTypesTuple)
    kinds = {type(item) for item in value}
    if can_be_str and len(kinds) == 2:
        kinds.discard(str)
    return len(kinds) <= 1 and kinds <= set(ScalarTypesTuple)


def is_instance_of(value: Any, data_type: AllowedTypesType = None, can_be_str: bool = False) -> bool:
    """Return True if the value has the type; with ``can_be_str`` also for texts in its place."""
    if data_type is None:
        return is_instance_of_valid_type(value, can_be_str)
    scalar, is_list = extract_type(data_type)
    kinds = (str, scalar) if can_be_str else (scalar,)
    if is_list:
        return isinstance(value, list) and all(isinstance(item, kinds) for item in value)
    return isinstance(value, kinds)


def coerce_to_type(value: str, data_type: AllowedTypesType = None, can_be_str: bool = False) -> StrSomeValueType:
    """
    Read a text as a value of a type; without a type as YAML does.

    :param can_be_str: keep a text that cannot be read so, as it may hold substitutions
    :raises ValueError: if it is no such value
    :raises TypeError: if it is no text
    """
    ensure_argument_type(value, str, 'value', 'coerce_to_type')
    if data_type is None:
        if not value:  # YAML makes nothing of it; it is a text without characters
            return value
        return _from_yaml(value, f"Failed to convert '{value}' using yaml rules", can_be_str)
    scalar, is_list = extract_type(data_type)
    kinds = (str, scalar) if can_be_str else (scalar,)
    if is_list:
        failure = f"Cannot convert value '{value}' to a list of '{kinds if can_be_str else scalar}'"
        items = _from_yaml(value, failure, can_be_str)
        if not isinstance(items, list):
            raise ValueError(failure)
        if not all(isinstance(item, kinds) for item in items):
            raise ValueError(f'{failure}, got {items}')
        return items
    if scalar is str:
        return value
    if scalar is bool:
        result = _from_yaml(value, f"Failed to convert '{value}' to '{scalar}'", can_be_str)
        if not isinstance(result, kinds):
            raise ValueError(f"Cannot convert value '{value}' to '{scalar}'")
        return result
    try:
        return scalar(value)
    except ValueError:
        if can_be_str:
            return value
        raise


def _from_yaml(text: str, failure: str, can_be_str: bool) -> Any:
    try:
        value = yaml.safe_load(text)
    except yaml.YAMLError as error:
        if can_be_str:
            return text
        raise ValueError(f'{failure}: yaml.safe_load() failed\n{error}') from error
    if not is_instance_of_valid_type(value, can_be_str):
        raise ValueError(f'{failure}: output type is not allowed, got {type(value)}')
    return value


def coerce_list(value: list[str], data_type: AllowedTypesType = None, can_be_str: bool = False) -> list:
    """
    Read each text of a list as a value of a type.

    :raises ValueError: if one of them is none, or they differ in type
    """
    ensure_argument_type(value, list, 'value', 'coerce_list')
    result = [coerce_to_type(item, data_type, can_be_str) for item in value]
    if not is_instance_of_valid_type(result, can_be_str):
        raise ValueError(f'cannot convert value to {data_type}. Got value=`{value}`')
    return result


def get_typed_value(value: str | list[str], data_type: AllowedTypesType, can_be_str: bool = False) -> StrSomeValueType:
    """
    Read a text, or a list of texts, as a value of a type.

    :raises ValueError: if it is no such value
    :raises TypeError: if it is a list and the type is not
    """
    if not isinstance(value, list):
        return coerce_to_type(value, data_type, can_be_str)
    if data_type is None:
        return coerce_list(value, None, can_be_str)
    scalar, is_list = extract_type(data_type)
    if not is_list:
        raise TypeError(f"Cannot convert input '{value}' of type '{type(value)}' to '{scalar}'")
    return coerce_list(value, scalar, can_be_str)


def is_substitution(value: Any) -> bool:
    """Return True for a substitution, or a list of texts and at least one substitution."""
    if isinstance(value, Substitution):
        return True
    if isinstance(value, str) or not isinstance(value, Iterable):
        return False
    items = list(value)
    return all(isinstance(item, (Substitution, str)) for item in items) and any(
        isinstance(item, Substitution) for item in items
    )


def normalize_typed_substitution(value: SomeValueType, data_type: AllowedTypesType = None) -> NormalizedValueType:
    """
    Check a value that an action takes, and bring it into the form that ``perform_typed_substitution`` wants.

    :raises TypeError: if it can never become a value of the type
    """
    if isinstance(value, ScalarTypesTuple):
        if not is_instance_of(value, data_type):
            raise TypeError(f"value='{value}' is not an instance of {data_type}")
        return value
    if is_substitution(value):
        return normalize_to_list_of_substitutions(value)
    if not isinstance(value, Iterable):
        raise TypeError(
            'value should be either a scalar, a substitutions, or a mixed list of scalars and '
            f'substitutions. Got `value={value}` of type `{type(value)}`. '
        )
    items = [item if isinstance(item, ScalarTypesTuple) else normalize_to_list_of_substitutions(item) for item in value]
    kinds = {type(item) for item in items if not isinstance(item, list)}
    if kinds == {int, float}:
        items, kinds = [float(item) if isinstance(item, int) else item for item in items], {float}
    wanted = None if data_type is None else extract_type(data_type)
    if len(kinds) > 1 or (wanted and (not wanted[1] or not kinds <= {wanted[0]})):
        raise TypeError(f'Got a list of types {kinds}, which cannot become a value of type {data_type}')
    return items


def perform_typed_substitution(
    context: LaunchContext, value: NormalizedValueType, data_type: AllowedTypesType = None
) -> AllowedValueType:
    """
    Return the value of what ``normalize_typed_substitution`` gave.

    :raises ValueError: if a text is no value of the type
    """
    if isinstance(value, ScalarTypesTuple):
        if not is_instance_of(value, data_type):
            raise ValueError(f"value='{value}' is not an instance of {data_type}")
        return value
    if value and all(isinstance(item, Substitution) for item in value):
        return coerce_to_type(perform_substitutions(context, value), data_type)
    scalar = None if data_type is None else extract_type(data_type)[0]
    return [
        coerce_to_type(perform_substitutions(context, item), scalar) if isinstance(item, list) else item
        for item in value
    ]


def to_number(context: LaunchContext, value: float | SomeSubstitutionsType) -> float:
    """Return the number that ``value`` stands for at this moment."""
    if isinstance(value, (int, float)):
        return float(value)
    return float(perform_substitutions(context, normalize_to_list_of_substitutions(value)))


def to_bool(context: LaunchContext, value: bool | SomeSubstitutionsType) -> bool:
    """
    Return the truth value that ``value`` stands for: YAML's words (true, yes, on …), 1 or 0.

    :raises ValueError: for any other text
    """
    if isinstance(value, bool):
        return value
    text = perform_substitutions(context, normalize_to_list_of_substitutions(value)).strip()
    return text == '1' if text in ('0', '1') else coerce_to_type(text, bool)
