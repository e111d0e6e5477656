"""Where the log files are."""

import launch.logging
from launch.frontend.expose import expose_substitution
from launch.launch_context import LaunchContext
from launch.substitutions.arguments import counted
from launch.substitutions.path_join_substitution import PathSubstitution
from launch.substitutions.substitution_failure import SubstitutionFailure


@expose_substitution('launch_log_dir')
@expose_substitution('log_dir')
class LaunchLogDir(PathSubstitution):
    """The directory of the log files of this launch."""

    def __init__(self):
        super().__init__(self)

    @classmethod
    def parse(cls, data):
        """Read ``$(launch_log_dir)``, or ``$(log_dir)``."""
        counted('launch_log_dir', data, 0)
        return cls, {}

    def describe(self) -> str:
        return 'LaunchLogDir()'

    def perform(self, context: LaunchContext) -> str:
        path = launch.logging.launch_config.log_dir
        if path is None:
            raise SubstitutionFailure(f'there are no log files: {launch.logging.launch_config.failure}')
        return path
