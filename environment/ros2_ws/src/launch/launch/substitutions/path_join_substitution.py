"""Paths, made of parts or going on with the operator /."""

import os
from collections.abc import Iterable

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
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


class PathSubstitution(PathJoinSubstitution):
    """
    A single path, which the operator ``/`` goes on with: ``PathSubstitution('share') / 'maps' / 'flat.yaml'``.

    Substitutions that are directories derive from it and give themselves as the path.
    """

    def __init__(self, path: SomeSubstitutionsType):
        super().__init__([path])
