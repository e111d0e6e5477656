"""The verb `ros2 lifecycle nodes`."""

from ros2cli.node.arguments import add_arguments

from ros2lifecycle.api import get_node_names
from ros2lifecycle.verb import VerbExtension


class NodesVerb(VerbExtension):
    """Output a list of nodes with lifecycle."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('-a', '--all', action='store_true', help='List hidden nodes as well')
        parser.add_argument('-c', '--count-nodes', action='store_true', help='Print only how many nodes there are')

    def main(self, *, args):
        """Print the names."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            names = {name.full_name for name in get_node_names(node=node, include_hidden_nodes=args.all)}
        if args.count_nodes:
            print(len(names))
        else:
            for name in sorted(names):
                print(name)
