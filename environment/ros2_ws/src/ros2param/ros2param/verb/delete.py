"""The verb `ros2 param delete`."""

import sys

from ros2cli.node.arguments import add_arguments
from ros2node.api import get_absolute_node_name

from ros2param.api import ParameterNameCompleter, add_node_arguments, call_set_parameters, node_is_there
from ros2param.verb import VerbExtension


class DeleteVerb(VerbExtension):
    """Delete parameter."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        add_node_arguments(parser)
        argument = parser.add_argument('parameter_name', help='Name of the parameter')
        argument.completer = ParameterNameCompleter()

    def main(self, *, args):
        """Undeclare the parameter, which a node must allow, and print whether it did."""
        from rcl_interfaces.msg import Parameter
        from ros2cli.node.strategy import NodeStrategy

        name = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            if not node_is_there(node, name, args.include_hidden_nodes, args.timeout):
                return 'Node not found'
            # A value of type "not set", which a Parameter has by default, means: delete.
            response = call_set_parameters(node=node, node_name=name, parameters=[Parameter(name=args.parameter_name)])
        result = response.results[0]
        reason = f': {result.reason}' if result.reason else ''
        if result.successful:
            print(f'Deleted parameter successfully{reason}')
        else:
            print(f'Deleting parameter failed{reason}', file=sys.stderr)
