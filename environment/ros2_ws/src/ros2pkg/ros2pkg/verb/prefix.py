"""The verb `ros2 pkg prefix`."""

import os

from ros2pkg.api import get_prefix_path, package_name_completer
from ros2pkg.verb import VerbExtension


class PrefixVerb(VerbExtension):
    """Output the prefix path of a package."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        argument = parser.add_argument('package_name', help='Name of the package')
        argument.completer = package_name_completer
        parser.add_argument('--share', action='store_true', help="Print the package's share directory instead")

    def main(self, *, args):
        """Print where the package is installed."""
        prefix = get_prefix_path(args.package_name)
        if prefix is None:
            return 'Package not found'
        print(os.path.join(prefix, 'share', args.package_name) if args.share else prefix)
