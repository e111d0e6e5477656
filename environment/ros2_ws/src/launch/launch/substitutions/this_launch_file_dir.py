"""The directory of the launch file."""

from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.substitutions.arguments import counted
from launch.substitutions.path_join_substitution import PathSubstitution
from launch.substitutions.substitution_failure import SubstitutionFailure


@expose_substitution('dirname')
class ThisLaunchFileDir(PathSubstitution):
    """The directory of the launch file."""

    def __init__(self):
        super().__init__(self)

    @classmethod
    def parse(cls, data):
        """Read ``$(dirname)``."""
        counted('dirname', data, 0)
        return cls, {}

    def describe(self) -> str:
        return 'ThisLaunchFileDir()'

    def perform(self, context: LaunchContext) -> str:
        path = context.get_locals_as_dict().get('current_launch_file_directory')
        if path is None:
            raise SubstitutionFailure('ThisLaunchFileDir used outside of a launch file (in a script)')
        return path
