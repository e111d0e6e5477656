"""The verb `ros2 param load`."""

from ros2cli.node.arguments import add_arguments
from ros2node.api import get_absolute_node_name

from ros2param.api import add_node_arguments, load_parameter_file, node_is_there
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
            load_parameter_file(
                node=node, node_name=name, parameter_file=args.parameter_file, use_wildcard=not args.no_use_wildcard
            )
