"""The verb `ros2 lifecycle list`."""

from ros2cli.node.arguments import add_arguments
from ros2node.api import NodeNameCompleter, get_absolute_node_name

from ros2lifecycle.api import call_get_available_transitions, call_get_transition_graph, get_node_names
from ros2lifecycle.verb import VerbExtension


class ListVerb(VerbExtension):
    """Output a list of available transitions."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('node_name', help='Name of the node')
        argument.completer = NodeNameCompleter(include_hidden_nodes_key='include_hidden_nodes')
        parser.add_argument('--include-hidden-nodes', action='store_true', help='Consider hidden nodes as well')
        parser.add_argument(
            '-a', '--all', action='store_true', help='List the transitions from all states, not only the current one'
        )

    def main(self, *, args):
        """Print the transitions."""
        from ros2cli.node.strategy import NodeStrategy

        name = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            found = get_node_names(node=node, include_hidden_nodes=args.include_hidden_nodes)
            if name not in {each.full_name for each in found}:
                return 'Node not found'
            ask = call_get_transition_graph if args.all else call_get_available_transitions
            transitions = ask(node=node, states={name: None})[name]
        if isinstance(transitions, TimeoutError):
            return f"Exception while calling service of node '{name}': {transitions}"
        for each in transitions:
            print(
                f'- {each.transition.label} [{each.transition.id}]\n'
                f'\tStart: {each.start_state.label}\n\tGoal: {each.goal_state.label}'
            )
