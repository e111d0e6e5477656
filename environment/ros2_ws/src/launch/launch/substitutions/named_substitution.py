"""Texts that are looked up by a name."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


class NamedSubstitution(Substitution):
    """Something of the context that has a name and perhaps a default."""

    _label = ''

    def __init__(self, name: SomeSubstitutionsType, *, default=None):
        self._name = normalize_to_list_of_substitutions(name)
        if isinstance(default, (int, float)):  # upstream takes numbers, too
            default = str(default)
        self._default = None if default is None else normalize_to_list_of_substitutions(default)

    def describe(self) -> str:
        return f'{self._label}({describe_substitutions(self._name)})'

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self._name)
        value = self._look_up(context, name)
        if value is None:
            if self._default is None:
                raise SubstitutionFailure(self._failure(name))
            return perform_substitutions(context, self._default)
        return value

    def _look_up(self, context: LaunchContext, name: str) -> str | None:
        raise NotImplementedError

    def _failure(self, name: str) -> str:
        raise NotImplementedError
