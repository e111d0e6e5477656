"""Where things are: the paths of one checkout of the course."""

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Layout:
    """Paths below the repository's root."""

    root: Path

    @property
    def prefix(self) -> Path:
        """The virtual environment, which is also the ament prefix that colcon installs into."""
        return self.root / '.venv'

    @property
    def python(self) -> Path:
        return self.prefix / 'bin' / 'python'

    @property
    def state(self) -> Path:
        """What the set-up remembers; inside the environment, so that both vanish together."""
        return self.prefix / '.course'

    @property
    def logs(self) -> Path:
        return self.state / 'log'

    @property
    def build(self) -> Path:
        """Where colcon works; removed when all packages are built."""
        return self.state / 'build'

    @property
    def requirements(self) -> Path:
        return self.root / 'environment' / 'requirements.lock'

    @property
    def sources(self) -> Path:
        return self.root / 'environment' / 'ros2_ws' / 'src'

    @property
    def cmake(self) -> Path:
        """CMake code that makes the build of packages shorter."""
        return self.root / 'environment' / 'ros2_ws' / 'cmake'

    @property
    def cmake_include(self) -> Path:
        """The part of it that every package's build includes."""
        return self.cmake / 'python_interfaces.cmake'

    @property
    def builder(self) -> Path:
        """The program that runs colcon."""
        return self.root / 'environment' / 'builder'

    @property
    def installed(self) -> Path:
        """For each of the course's packages, a list of what it has installed."""
        return self.state / 'installed'

    @property
    def mutex(self) -> Path:
        return self.root / 'environment' / '.lock'

    def site_packages(self) -> Path:
        """Raises FileNotFoundError when there is no environment yet."""
        for found in sorted((self.prefix / 'lib').glob('python3.*/site-packages')):
            return found
        raise FileNotFoundError(f'no site-packages below {self.prefix}')
