"""The verb `ros2 interface packages`."""

from ros2interface.verb import VerbExtension


class PackagesVerb(VerbExtension):
    """Output a list of packages that provide interfaces."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('-m', '--only-msgs', action='store_true', help='Only packages with messages')
        parser.add_argument('-s', '--only-srvs', action='store_true', help='Only packages with services')
        parser.add_argument('-a', '--only-actions', action='store_true', help='Only packages with actions')

    def main(self, *, args):
        """Print the names; with several options, packages that have all of these kinds."""
        from rosidl_runtime_py import (
            get_action_interfaces,
            get_interface_packages,
            get_message_interfaces,
            get_service_interfaces,
        )

        packages = set(get_interface_packages())
        for flag, get in (
            (args.only_msgs, get_message_interfaces),
            (args.only_srvs, get_service_interfaces),
            (args.only_actions, get_action_interfaces),
        ):
            if flag:
                packages &= set(get())
        for package in sorted(packages):
            print(package)
