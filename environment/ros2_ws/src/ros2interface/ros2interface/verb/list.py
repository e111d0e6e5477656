"""The verb `ros2 interface list`."""

from ros2interface.verb import VerbExtension


class ListVerb(VerbExtension):
    """List all interface types available."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('-m', '--only-msgs', action='store_true', help='Print only messages')
        parser.add_argument('-s', '--only-srvs', action='store_true', help='Print only services')
        parser.add_argument('-a', '--only-actions', action='store_true', help='Print only actions')

    def main(self, *, args):
        """Print the names under a heading for each kind."""
        from rosidl_runtime_py import get_action_interfaces, get_message_interfaces, get_service_interfaces

        kinds = (
            ('Messages', args.only_msgs, get_message_interfaces),
            ('Services', args.only_srvs, get_service_interfaces),
            ('Actions', args.only_actions, get_action_interfaces),
        )
        everything = not any(chosen for _, chosen, _ in kinds)
        for title, chosen, get in kinds:
            if chosen or everything:
                print(f'{title}:')
                for package, names in sorted(get().items()):
                    for name in names:
                        print(f'    {package}/{name}')
