"""The verb `ros2 node info`."""

import sys

from ros2cli.node.arguments import add_arguments

from ros2node import api
from ros2node.verb import VerbExtension

_SECTIONS = (
    ('Subscribers', api.get_subscriber_info),
    ('Publishers', api.get_publisher_info),
    ('Service Servers', api.get_service_server_info),
    ('Service Clients', api.get_service_client_info),
    ('Action Servers', api.get_action_server_info),
    ('Action Clients', api.get_action_client_info),
)


class InfoVerb(VerbExtension):
    """Output information about a node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('node_name', help='Full name of the node, for example /talker')
        argument.completer = api.NodeNameCompleter(include_hidden_nodes_key='include_hidden')
        parser.add_argument(
            '--include-hidden',
            action='store_true',
            help='Consider hidden nodes, and show hidden topics, services and actions as well',
        )

    def main(self, *, args):
        """Print what the node publishes, subscribes to, offers and uses."""
        from ros2cli.node.strategy import NodeStrategy

        full_name = api.get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            names = api.get_node_names(node=node, include_hidden_nodes=args.include_hidden)
            count = [name.full_name for name in names].count(full_name)
            if count == 0:
                return f"Unable to find node '{args.node_name}'"
            if count > 1:
                print(api.INFO_NONUNIQUE_WARNING_TEMPLATE.format(num_nodes=count, node_name=full_name), file=sys.stderr)
            sections = [
                (title, get(node=node, remote_node_name=full_name, include_hidden=args.include_hidden))
                for title, get in _SECTIONS
            ]
        print(full_name)
        for title, entries in sections:
            print(f'  {title}:')
            print('\n'.join(f'    {entry.name}: {", ".join(entry.types)}' for entry in entries))
