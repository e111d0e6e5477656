"""What a file holds."""

from pathlib import Path

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, perform_substitutions


@expose_substitution('file-content')
class FileContent(Substitution):
    """The text of a file, e.g. of a robot's URDF."""

    def __init__(self, path: SomeSubstitutionsType):
        self._path = normalize_to_list_of_substitutions(path)

    @classmethod
    def parse(cls, data):
        """Read ``$(file-content path)``."""
        return cls, {'path': counted('file-content', data, 1)[0]}

    @property
    def path(self):
        """The path, as substitutions."""
        return self._path

    def describe(self) -> str:
        return f'FileContent({describe_substitutions(self._path)})'

    def perform(self, context: LaunchContext) -> str:
        path = perform_substitutions(context, self._path)
        try:
            return Path(path).read_text(encoding='utf-8')
        except (OSError, UnicodeDecodeError) as error:
            raise SubstitutionFailure(f"cannot read the file '{path}': {error}") from error
