"""The path of a program of a package."""

import os
import shutil

from launch.frontend import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions import SubstitutionFailure
from launch.utilities import describe_substitutions, to_text

from launch_ros.substitutions.find_package import FindPackagePrefix


@expose_substitution('exec-in-pkg')
class ExecutableInPackage(FindPackagePrefix):
    """The path of a program in the package's lib/PACKAGE, where ``ros2 run`` looks, too."""

    def __init__(self, executable: SomeSubstitutionsType, package: SomeSubstitutionsType):
        super().__init__(package)
        self.executable = executable

    @classmethod
    def parse(cls, data):
        """Read ``$(exec-in-pkg executable package)``."""
        if len(data) != 2:
            raise TypeError(f'exec-in-pkg substitution expects 2 arguments, got {len(data)}')
        return cls, {'executable': data[0], 'package': data[1]}

    def describe(self) -> str:
        return f'ExecInPkg(pkg={describe_substitutions(self.package)}, exec={describe_substitutions(self.executable)})'

    def perform(self, context: LaunchContext) -> str:
        package, executable = to_text(context, self.package), to_text(context, self.executable)
        prefix = super().perform(context)
        libexec = os.path.join(prefix, 'lib', package)
        if not os.path.exists(libexec):
            raise SubstitutionFailure(
                f"package '{package}' found at '{prefix}', but libexec directory '{libexec}' does not exist"
            )
        path = shutil.which(executable, path=libexec)
        if path is None:
            raise SubstitutionFailure(f"executable '{executable}' not found on the libexec directory '{libexec}' ")
        return path
