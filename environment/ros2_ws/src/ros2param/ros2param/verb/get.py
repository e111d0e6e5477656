"""The verb `ros2 param get`."""

from ros2cli.node.arguments import add_arguments
from ros2node.api import get_absolute_node_name

from ros2param.api import (
    ParameterNameCompleter,
    add_node_arguments,
    call_get_parameters,
    get_label,
    get_raw_value,
    node_is_there,
)
from ros2param.verb import VerbExtension


class GetVerb(VerbExtension):
    """Get parameter."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        add_node_arguments(parser)
        argument = parser.add_argument('parameter_name', help='Name of the parameter')
        argument.completer = ParameterNameCompleter()
        parser.add_argument('--hide-type', action='store_true', help='Print the value alone')

    def main(self, *, args):
        """Print the value."""
        from ros2cli.node.strategy import NodeStrategy

        name = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            if not node_is_there(node, name, args.include_hidden_nodes, args.timeout):
                return 'Node not found'
            response = call_get_parameters(node=node, node_name=name, parameter_names=[args.parameter_name])
        if not response.values:
            return 'Parameter not set'
        value = get_raw_value(response.values[0])
        label = get_label(response.values[0].type)
        if args.hide_type:
            print(value)
        elif value is None:
            print(label)
        else:
            print(label, value)
