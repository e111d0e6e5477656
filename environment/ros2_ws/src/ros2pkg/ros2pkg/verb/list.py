"""The verb `ros2 pkg list`."""

from ros2pkg.api import get_package_names
from ros2pkg.verb import VerbExtension


class ListVerb(VerbExtension):
    """Output a list of available packages."""

    def main(self, *, args):
        """Print the names in alphabetical order."""
        for name in get_package_names():
            print(name)
