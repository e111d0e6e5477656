"""Parameters whose type is said on purpose, and parameter files."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import yaml
from launch.frontend import Parser, parse_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions import SubstitutionFailure
from launch.utilities import perform_substitutions, to_text
from launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution, to_bool


class ParameterValue:
    """
    A parameter value with its type.

    :param value: a plain value, or substitutions
    :param value_type: bool, int, float, str, a List of one of them, or None to let YAML decide. With str a text stays
        a text.
    :raises TypeError: if the value can never be of the type
    """

    def __init__(self, value: Any, *, value_type: Any = None):
        self.value, self.value_type = normalize_typed_substitution(value, value_type), value_type

    def evaluate(self, context: LaunchContext) -> Any:
        """
        Return the plain value.

        :raises ValueError: if the text is not of the type
        """
        return perform_typed_substitution(context, self.value, self.value_type)


class Parameter:
    """
    A parameter with its name and its type, as an item of a node's parameters.

    :param name: the name; with dots for one in a group
    :param value: a plain value, or substitutions
    :param value_type: as that of ``ParameterValue``
    """

    def __init__(self, name: SomeSubstitutionsType, value: Any, *, value_type: type | None = None):
        self.name, self.parameter_value = name, ParameterValue(value, value_type=value_type)

    def evaluate(self, context: LaunchContext) -> tuple[str, Any]:
        """
        Return the name and the plain value.

        :raises ValueError: if the text is not of the type
        """
        return to_text(context, self.name), self.parameter_value.evaluate(context)


def is_one_text(value: Any) -> bool:
    """Return True for a list of texts and at least one substitution, which together become one text."""
    return (
        isinstance(value, (list, tuple))
        and all(isinstance(item, (str, Substitution)) for item in value)
        and any(isinstance(item, Substitution) for item in value)
    )


class ParameterFile:
    """
    A parameter file.

    :param param_file: its path
    :param allow_substs: replace the substitutions inside the file, e.g. ``$(var name)``
    """

    def __init__(self, param_file: SomeSubstitutionsType, *, allow_substs: bool | SomeSubstitutionsType = False):
        self.param_file, self.allow_substs = param_file, allow_substs

    def evaluate(self, context: LaunchContext) -> Path:
        """
        Return the path of the file to use: with substitutions, of a copy that is removed when the launch ends.

        :raises SubstitutionFailure: if a substitution has no text, or the result is no YAML
        :raises OSError: if the file cannot be read
        """
        path = Path(to_text(context, self.param_file))
        if not to_bool(context, self.allow_substs):
            return path
        Parser.load_launch_extensions()
        text = perform_substitutions(context, parse_substitution(path.read_text(encoding='utf-8')))
        try:
            yaml.safe_load(text)
        except yaml.YAMLError as error:
            raise SubstitutionFailure(f'The substituted parameter file is not a valid yaml file: {error}') from error
        return write_temporary_file(context, text)


def write_temporary_file(context: LaunchContext, text: str) -> Path:
    """Write a parameter file that is removed when the launch ends; return its path."""
    with tempfile.NamedTemporaryFile('w', prefix='launch_params_', suffix='.yaml', delete=False) as file:
        file.write(text)
    path = Path(file.name)
    context.call_at_end(lambda: path.unlink(missing_ok=True))
    return path
