"""The verb `ros2 pkg executables`."""

import os

from ros2pkg.api import PackageNotFound, get_executable_paths, get_package_names, package_name_completer
from ros2pkg.verb import VerbExtension


class ExecutablesVerb(VerbExtension):
    """Output a list of package specific executables."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        argument = parser.add_argument('package_name', nargs='?', help='Name of the package; without one, all packages')
        argument.completer = package_name_completer
        parser.add_argument('--full-path', action='store_true', help='Print the path of each executable')

    def main(self, *, args):
        """Print package and executable, one a line."""
        names = get_package_names() if args.package_name is None else [args.package_name]
        for name in names:
            try:
                paths = get_executable_paths(package_name=name)
            except PackageNotFound:
                return f"Package '{name}' not found"
            for path in sorted(paths):
                print(path if args.full_path else f'{name} {os.path.basename(path)}')
