"""The path of the launch file."""

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.arguments import counted
from launch.substitutions.substitution_failure import SubstitutionFailure


@expose_substitution('filename')
class ThisLaunchFile(Substitution):
    """The path of the launch file."""

    @classmethod
    def parse(cls, data):
        """Read ``$(filename)``."""
        counted('filename', data, 0)
        return cls, {}

    def describe(self) -> str:
        return 'ThisLaunchFile()'

    def perform(self, context: LaunchContext) -> str:
        path = context.get_locals_as_dict().get('current_launch_file_path')
        if path is None:
            raise SubstitutionFailure('ThisLaunchFile used outside of a launch file (in a script)')
        return path
