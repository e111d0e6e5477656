"""Texts that are paths."""

import os
import shutil
from collections.abc import Iterable

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


class PathJoinSubstitution(Substitution):
    """A path made of parts; a part may itself be several texts in a row."""

    def __init__(self, substitutions: Iterable[SomeSubstitutionsType]):
        self.substitutions = [normalize_to_list_of_substitutions(part) for part in substitutions]

    def __truediv__(self, additional_path: SomeSubstitutionsType) -> 'PathJoinSubstitution':
        return PathJoinSubstitution([*self.substitutions, additional_path])

    def describe(self) -> str:
        return f'PathJoin({", ".join(describe_substitutions(part) for part in self.substitutions)})'

    def perform(self, context: LaunchContext) -> str:
        return os.path.join(*(perform_substitutions(context, part) for part in self.substitutions))


class FindExecutable(Substitution):
    """The path of a program on the PATH."""

    def __init__(self, *, name: SomeSubstitutionsType):
        self._name = normalize_to_list_of_substitutions(name)

    def describe(self) -> str:
        return f'FindExec({describe_substitutions(self._name)})'

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self._name)
        path = shutil.which(name, path=context.environment.get('PATH'))
        if path is None:
            raise SubstitutionFailure(f"executable '{name}' not found on the PATH")
        return path
