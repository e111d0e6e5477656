"""The verb `ros2 lifecycle get`."""

import sys

from ros2cli.node.arguments import add_arguments
from ros2node.api import NodeNameCompleter, get_absolute_node_name

from ros2lifecycle.api import call_get_states, get_node_names
from ros2lifecycle.verb import VerbExtension


class GetVerb(VerbExtension):
    """Get lifecycle state for one or more nodes."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument(
            'node_name', nargs='?', help='Name of the node; without one, all managed nodes are asked'
        )
        argument.completer = NodeNameCompleter(include_hidden_nodes_key='include_hidden_nodes')
        parser.add_argument('--include-hidden-nodes', action='store_true', help='Consider hidden nodes as well')

    def main(self, *, args):
        """Print the states."""
        from ros2cli.node.strategy import NodeStrategy

        wanted = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            found = get_node_names(node=node, include_hidden_nodes=args.include_hidden_nodes)
            names = sorted({name.full_name for name in found})
            if wanted:
                if wanted not in names:
                    return 'Node not found'
                names = [wanted]
            for name in names:
                state = call_get_states(node=node, node_names=[name])[name]
                if isinstance(state, TimeoutError):
                    print(f"Exception while calling service of node '{name}': {state}", file=sys.stderr)
                    if wanted:
                        return 1
                    continue
                print(f'{"" if wanted else name + ": "}{state.label} [{state.id}]')
