"""Where a package is installed."""

from collections.abc import Callable

from ament_index_python.packages import get_package_prefix, get_package_share_directory
from launch.frontend import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions import PathSubstitution
from launch.utilities import describe_substitutions, to_text


class FindPackage(PathSubstitution):
    """A directory of a package. An unknown package raises PackageNotFoundError, with the paths searched."""

    _find: Callable[[str], str] = staticmethod(get_package_prefix)
    _word = ''

    def __init__(self, package: SomeSubstitutionsType):
        super().__init__(self)
        self.package = package

    @classmethod
    def parse(cls, data):
        """Read ``$(find-pkg-… package)``."""
        if len(data) != 1:
            raise TypeError(f'{cls._word} substitution expects 1 argument, got {len(data)}')
        return cls, {'package': data[0]}

    def describe(self) -> str:
        return f'{type(self).__name__}(pkg={describe_substitutions(self.package)})'

    def perform(self, context: LaunchContext) -> str:
        return self._find(to_text(context, self.package))


@expose_substitution('find-pkg-prefix')
class FindPackagePrefix(FindPackage):
    """The prefix that a package is installed in, e.g. /opt/ros/jazzy."""

    _word = 'find-pkg-prefix'


@expose_substitution('find-pkg-share')
class FindPackageShare(FindPackage):
    """The share directory of a package, with its launch files and configuration."""

    _word = 'find-pkg-share'
    _find = staticmethod(get_package_share_directory)
