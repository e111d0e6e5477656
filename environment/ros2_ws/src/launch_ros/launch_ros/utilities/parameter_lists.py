"""The parameters of a node, as a list, for programs that look at launch files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from launch.launch_context import LaunchContext

from launch_ros import parameters as _parameters
from launch_ros.parameter_descriptions import Parameter, ParameterFile


def normalize_parameters(parameters: Sequence) -> tuple[ParameterFile | Parameter | Mapping, ...]:
    """
    Return dictionaries, single parameters and files, for ``evaluate_parameters``.

    :param parameters: what a node is given as its parameters
    :raises TypeError: if it is no list, or has something else in it
    """
    if isinstance(parameters, str) or not isinstance(parameters, Sequence):
        raise TypeError(f'Expecting list of parameters, got {parameters}')
    _parameters.check_parameters(parameters)
    return tuple(
        item
        if isinstance(item, (Mapping, Parameter, ParameterFile))
        else ParameterFile(fspath(item) if isinstance(item, PathLike) else item)
        for item in parameters
    )


def evaluate_parameters(context: LaunchContext, parameters: Sequence) -> tuple[Path | Parameter | dict[str, Any], ...]:
    """
    Return paths of files, and dictionaries of names and plain values; lists become tuples.

    :param parameters: what ``normalize_parameters`` has returned
    :raises TypeError: for a value that no parameter can have
    """
    return tuple(_evaluated(context, item) for item in parameters)


def _evaluated(context: LaunchContext, item: ParameterFile | Parameter | Mapping) -> Path | Parameter | dict[str, Any]:
    if isinstance(item, ParameterFile):
        return item.evaluate(context)
    if isinstance(item, Parameter):
        return item
    values = _parameters.evaluate_parameters(context, item)
    return {name: tuple(value) if isinstance(value, list) else value for name, value in values.items()}
