"""The verb `ros2 param list`."""

import re
import sys

from ros2cli.node.arguments import add_arguments
from ros2node.api import NodeNameCompleter, get_absolute_node_name, get_node_names

from ros2param.api import call_describe_parameters, call_list_parameters, get_parameter_type_string
from ros2param.verb import VerbExtension


class ListVerb(VerbExtension):
    """Output a list of available parameters."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument(
            'node_name', nargs='?', help='Name of the node; without one, all nodes are asked'
        )
        argument.completer = NodeNameCompleter(include_hidden_nodes_key='include_hidden_nodes')
        parser.add_argument('--include-hidden-nodes', action='store_true', help='Consider hidden nodes as well')
        parser.add_argument(
            '--param-prefixes', nargs='+', default=[], help='List only parameters that begin with one of these'
        )
        parser.add_argument('--param-type', action='store_true', help='Print the type of each parameter as well')
        parser.add_argument(
            '--filter', help='List only parameters that this regular expression matches from their beginning'
        )

    def main(self, *, args):
        """Print the names of the parameters of each node."""
        from ros2cli.node.strategy import NodeStrategy

        try:
            pattern = re.compile(args.filter or '')
        except re.error as e:
            return f"Invalid regular expression '{args.filter}': {e}"
        wanted = get_absolute_node_name(args.node_name)
        with NodeStrategy(args) as node:
            found = get_node_names(node=node, include_hidden_nodes=args.include_hidden_nodes)
            names = sorted({name.full_name for name in found})
            if wanted:
                if wanted not in names:
                    return 'Node not found'
                names = [wanted]
            services = dict(node.get_service_names_and_types())
            for name in names:
                # A node may be made without parameter services.
                if f'{name}/list_parameters' in services:
                    self._print(node, name, args, pattern)

    def _print(self, node, name, args, pattern):
        try:
            parameters = [
                each
                for each in call_list_parameters(node=node, node_name=name, prefixes=args.param_prefixes)
                if pattern.match(each)
            ]
            types = {}
            if args.param_type and parameters:
                response = call_describe_parameters(node=node, node_name=name, parameter_names=parameters)
                types = {each.name: get_parameter_type_string(each.type) for each in response.descriptors}
        except RuntimeError as e:
            print(f"Exception while calling service of node '{name}': {e}", file=sys.stderr)
            return
        if parameters and not args.node_name:
            print(f'{name}:')
        for each in parameters:
            print(f'  {each} (type: {types[each]})' if each in types else f'  {each}')
