"""The verb `ros2 action info`."""

from ros2cli.node.arguments import add_arguments

from ros2action.api import action_name_completer, get_action_clients_and_servers
from ros2action.verb import VerbExtension


class InfoVerb(VerbExtension):
    """Print information about an action."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('action_name', help='Name of the action, for example /fibonacci')
        argument.completer = action_name_completer
        parser.add_argument('-t', '--show-types', action='store_true', help='Show the type of the action as well')
        parser.add_argument(
            '-c', '--count', action='store_true', help='Print only how many clients and servers there are'
        )

    def main(self, *, args):
        """Print which nodes use and which offer the action."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            clients, servers = get_action_clients_and_servers(node=node, action_name=args.action_name)
        print(f'Action: {args.action_name}')
        for title, nodes in (('clients', clients), ('servers', servers)):
            print(f'Action {title}: {len(nodes)}')
            if not args.count:
                for name, types in nodes:
                    print(f'    {name} [{", ".join(types)}]' if args.show_types else f'    {name}')
