"""Parameters whose type is said on purpose."""

from __future__ import annotations

from typing import Any

import yaml
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import to_text


class ParameterValue:
    """
    A parameter value with its type.

    :param value: a plain value, or substitutions
    :param value_type: bool, int, float, str, or None to let YAML decide. With str a text stays a text.
    """

    def __init__(self, value: Any, *, value_type: type | None = None):
        self.value, self.value_type = value, value_type

    def evaluate(self, context: LaunchContext) -> Any:
        """
        Return the plain value.

        :raises ValueError: if the text is not of the type
        """
        value = self.value
        substitutes = isinstance(value, Substitution) or (
            isinstance(value, (list, tuple)) and any(isinstance(item, Substitution) for item in value)
        )
        if not substitutes:
            return value if self.value_type is None else self.value_type(value)
        text = to_text(context, value)
        if self.value_type is str:
            return text
        loaded = yaml.safe_load(text)
        if self.value_type is float and isinstance(loaded, int) and not isinstance(loaded, bool):
            return float(loaded)
        if self.value_type is not None and type(loaded) is not self.value_type:
            raise ValueError(f"Cannot convert value '{text}' to type '{self.value_type.__name__}'")
        return loaded


class ParameterFile:
    """
    A parameter file.

    :param param_file: its path
    :param allow_substs: not supported: substitutions inside the file
    """

    def __init__(self, param_file: SomeSubstitutionsType, *, allow_substs: bool = False):
        if allow_substs:
            raise NotImplementedError('substitutions inside a parameter file (allow_substs) are not supported')
        self.param_file = param_file
