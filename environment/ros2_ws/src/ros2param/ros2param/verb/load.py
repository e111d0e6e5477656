"""The verb `ros2 param load`."""

import sys

from ros2cli.node.arguments import add_arguments
from ros2node.api import get_absolute_node_name

from ros2param.api import add_node_arguments, call_set_parameters, node_is_there
from ros2param.verb import VerbExtension


class LoadVerb(VerbExtension):
    """Load parameter file for a node."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        add_node_arguments(parser)
        parser.add_argument('parameter_file', help='Parameter file, as `ros2 param dump` prints it')
        parser.add_argument(
            '--no-use-wildcard', action='store_true', help="Leave out the parameters of the name '/**' in the file"
        )

    def main(self, *, args):
        """Set every parameter of the file and print for each whether the node took it."""
        from ros2cli.node.strategy import NodeStrategy

        name = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            if not node_is_there(node, name, args.include_hidden_nodes, args.timeout):
                return 'Node not found'
            parameters = _read(args.parameter_file, name, not args.no_use_wildcard)
            response = call_set_parameters(node=node, node_name=name, parameters=parameters)
        for parameter, result in zip(parameters, response.results, strict=True):
            reason = f': {result.reason}' if result.reason else ''
            if result.successful:
                print(f'Set parameter {parameter.name} successful{reason}')
            else:
                print(f'Set parameter {parameter.name} failed{reason}', file=sys.stderr)


def _read(path, node_name, use_wildcard):
    import yaml
    from rclpy.parameter import parameter_dict_from_yaml_file

    try:
        with open(path, encoding='utf-8') as file:
            content = yaml.safe_load(file)
    except OSError as e:
        raise RuntimeError(f"Cannot read parameter file '{path}': {e.strerror}") from None
    except yaml.YAMLError as e:
        raise RuntimeError(f"Parameter file '{path}' is not valid YAML: {getattr(e, 'problem', e)}") from None
    if not isinstance(content, dict):
        raise RuntimeError(f"'{path}' is not a valid ROS parameter file")
    # The wildcard alone will do; rclpy insists on the node if it is named.
    targets = [key for key in (node_name, node_name.lstrip('/')) if key in content][:1]
    if not targets:
        if not (use_wildcard and '/**' in content):
            raise RuntimeError(
                f'Param file does not contain parameters for {node_name}, only for nodes: {list(content)}'
            )
        targets = ['/**']
    try:
        return list(parameter_dict_from_yaml_file(path, use_wildcard, targets).values())
    except (AssertionError, AttributeError, TypeError, ValueError) as e:
        raise RuntimeError(f"'{path}' is not a valid ROS parameter file: {e}") from None
