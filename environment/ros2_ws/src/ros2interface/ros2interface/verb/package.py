"""The verb `ros2 interface package`."""

from ros2interface.api import package_name_completer
from ros2interface.verb import VerbExtension


class PackageVerb(VerbExtension):
    """Output a list of available interface types within one package."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('-m', '--only-msgs', action='store_true', help='Print only messages')
        parser.add_argument('-s', '--only-srvs', action='store_true', help='Print only services')
        parser.add_argument('-a', '--only-actions', action='store_true', help='Print only actions')
        argument = parser.add_argument('package_name', help='Name of the package, for example example_interfaces')
        argument.completer = package_name_completer

    def main(self, *, args):
        """Print the full names."""
        from rosidl_runtime_py import get_interfaces

        chosen = [
            kind
            for kind, flag in (('msg', args.only_msgs), ('srv', args.only_srvs), ('action', args.only_actions))
            if flag
        ]
        try:
            names = get_interfaces([args.package_name])[args.package_name]
        except LookupError as e:
            return str(e)
        for name in names:
            if not chosen or name.partition('/')[0] in chosen:
                print(f'{args.package_name}/{name}')
