"""The verb `ros2 param describe`."""

from ros2cli.node.arguments import add_arguments
from ros2node.api import get_absolute_node_name

from ros2param.api import (
    ParameterNameCompleter,
    add_node_arguments,
    call_describe_parameters,
    get_parameter_type_string,
    node_is_there,
)
from ros2param.verb import VerbExtension


class DescribeVerb(VerbExtension):
    """Show descriptive information about declared parameters."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        add_node_arguments(parser)
        argument = parser.add_argument('parameter_names', nargs='+', help='Names of the parameters')
        argument.completer = ParameterNameCompleter()

    def main(self, *, args):
        """Print type, description and constraints of each."""
        from ros2cli.node.strategy import NodeStrategy

        name = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            if not node_is_there(node, name, args.include_hidden_nodes, args.timeout):
                return 'Node not found'
            response = call_describe_parameters(node=node, node_name=name, parameter_names=args.parameter_names)
        for descriptor in response.descriptors:
            _print(descriptor)


def _print(descriptor):
    print(f'Parameter name: {descriptor.name}')
    print(f'  Type: {get_parameter_type_string(descriptor.type)}')
    if descriptor.description:
        print(f'  Description: {descriptor.description}')
    print('  Constraints:')
    if descriptor.read_only:
        print('    Read only: true')
    for limits in (*descriptor.floating_point_range, *descriptor.integer_range):
        print(f'    Min value: {limits.from_value}')
        print(f'    Max value: {limits.to_value}')
        if limits.step:
            print(f'    Step: {limits.step}')
    if descriptor.additional_constraints:
        print(f'    Additional constraints: {descriptor.additional_constraints}')
