"""The verb `ros2 lifecycle set`."""

import sys

from ros2cli.node.arguments import add_arguments
from ros2node.api import NodeNameCompleter, get_absolute_node_name

from ros2lifecycle.api import call_change_states, call_get_available_transitions, get_node_names
from ros2lifecycle.verb import VerbExtension


class SetVerb(VerbExtension):
    """Trigger lifecycle state transition."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('node_name', help='Name of the node')
        argument.completer = NodeNameCompleter(include_hidden_nodes_key='include_hidden_nodes')
        parser.add_argument('--include-hidden-nodes', action='store_true', help='Consider hidden nodes as well')
        parser.add_argument('transition', help='The transition, by name or number, for example configure')

    def main(self, *, args):
        """Ask for the transition."""
        from ros2cli.node.strategy import NodeStrategy

        name = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            found = get_node_names(node=node, include_hidden_nodes=args.include_hidden_nodes)
            if name not in {each.full_name for each in found}:
                return 'Node not found'
            available = call_get_available_transitions(node=node, states={name: None})[name]
            if isinstance(available, TimeoutError):
                return f"Exception while calling service of node '{name}': {available}"
            transitions = [each.transition for each in available]
            chosen = [each for each in transitions if args.transition in (each.label, str(each.id))]
            if not chosen:
                return 'Unknown transition requested, available ones are:' + ''.join(
                    f'\n- {each.label} [{each.id}]' for each in transitions
                )
            success = call_change_states(node=node, transitions={name: chosen[0]})[name]
        if isinstance(success, TimeoutError):
            return f"Exception while calling service of node '{name}': {success}"
        if success:
            print('Transitioning successful')
        else:
            print('Transitioning failed', file=sys.stderr)
