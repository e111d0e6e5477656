"""The verb `ros2 param set`."""

import sys

from ros2cli.node.arguments import add_arguments
from ros2node.api import get_absolute_node_name

from ros2param.api import ParameterNameCompleter, add_node_arguments, call_set_parameters, node_is_there
from ros2param.verb import VerbExtension


class SetVerb(VerbExtension):
    """Set parameter."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        add_node_arguments(parser)
        argument = parser.add_argument('parameter_name', help='Name of the parameter')
        argument.completer = ParameterNameCompleter()
        parser.add_argument('value', help='Value of the parameter as YAML, which decides its type')

    def main(self, *, args):
        """Set the value and print whether the node took it."""
        import yaml
        from rcl_interfaces.msg import Parameter
        from rclpy.parameter import get_parameter_value
        from ros2cli.node.strategy import NodeStrategy

        try:
            value = get_parameter_value(string_value=args.value)
        except yaml.YAMLError as e:
            return f"The passed value '{args.value}' is not valid YAML: {getattr(e, 'problem', e)}"
        except (AssertionError, TypeError, ValueError) as e:
            return f"The passed value '{args.value}' is invalid: {e}"
        name = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            if not node_is_there(node, name, args.include_hidden_nodes, args.timeout):
                return 'Node not found'
            response = call_set_parameters(
                node=node, node_name=name, parameters=[Parameter(name=args.parameter_name, value=value)]
            )
        result = response.results[0]
        reason = f': {result.reason}' if result.reason else ''
        if result.successful:
            print(f'Set parameter successful{reason}')
        else:
            print(f'Setting parameter failed{reason}', file=sys.stderr)
