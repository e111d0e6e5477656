"""Where a package is installed."""

from collections.abc import Callable

from ament_index_python.packages import get_package_prefix, get_package_share_directory
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import describe_substitutions, to_text


class FindPackage(Substitution):
    """A directory of a package. An unknown package raises PackageNotFoundError, with the paths searched."""

    _find: Callable[[str], str] = staticmethod(get_package_prefix)

    def __init__(self, package: SomeSubstitutionsType):
        self.package = package

    def describe(self) -> str:
        return f'{type(self).__name__}(pkg={describe_substitutions(self.package)})'

    def perform(self, context: LaunchContext) -> str:
        return self._find(to_text(context, self.package))


class FindPackagePrefix(FindPackage):
    """The prefix that a package is installed in, e.g. /opt/ros/jazzy."""


class FindPackageShare(FindPackage):
    """The share directory of a package, with its launch files and configuration."""

    _find = staticmethod(get_package_share_directory)
