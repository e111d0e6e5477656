"""The path of a program."""

import shutil

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


@expose_substitution('find-exec')
class FindExecutable(Substitution):
    """The path of a program on the PATH."""

    def __init__(self, *, name: SomeSubstitutionsType):
        self._name = normalize_to_list_of_substitutions(name)

    @classmethod
    def parse(cls, data):
        """Read ``$(find-exec name)``."""
        return cls, {'name': counted('find-exec', data, 1)[0]}

    @property
    def name(self):
        """The name, as substitutions."""
        return self._name

    def describe(self) -> str:
        return f'FindExec({describe_substitutions(self._name)})'

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self._name)
        path = shutil.which(name, path=context.environment.get('PATH'))
        if path is None:
            raise SubstitutionFailure(f"executable '{name}' not found on the PATH")
        return path
