"""The verb `ros2 node list`."""

import sys

from ros2cli.node.arguments import add_arguments

from ros2node.api import get_node_names, has_duplicates
from ros2node.verb import VerbExtension


class ListVerb(VerbExtension):
    """Output a list of available nodes."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('-a', '--all', action='store_true', help='List hidden nodes as well')
        parser.add_argument('-c', '--count-nodes', action='store_true', help='Print only how many nodes there are')

    def main(self, *, args):
        """Print the names in alphabetical order."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            names = sorted(name.full_name for name in get_node_names(node=node, include_hidden_nodes=args.all))
        if args.count_nodes:
            print(len(names))
            return
        if has_duplicates(names):
            print(
                'WARNING: Be aware that there are nodes in the graph that share an exact name, '
                'which can have unintended side effects.',
                file=sys.stderr,
            )
        for name in names:
            print(name)
