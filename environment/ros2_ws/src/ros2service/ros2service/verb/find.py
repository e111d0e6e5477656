"""The verb `ros2 service find`."""

import argparse

from ros2cli.node.arguments import add_arguments

from ros2service.api import get_service_names_and_types, service_type_completer
from ros2service.verb import VerbExtension


class FindVerb(VerbExtension):
    """Output a list of available services of a given type."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('service_type', help='Type to look for, for example std_srvs/srv/Empty')
        argument.completer = service_type_completer
        parser.add_argument(
            '-c', '--count-services', action='store_true', help='Print only how many services there are'
        )
        parser.add_argument(
            '--include-hidden-services',
            action='store_true',
            default=argparse.SUPPRESS,
            help='List hidden services as well',
        )

    def main(self, *, args):
        """Print the names."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            services = get_service_names_and_types(node=node, include_hidden_services=args.include_hidden_services)
        names = [name for name, types in services if args.service_type in types]
        if args.count_services:
            print(len(names))
        else:
            for name in names:
                print(name)
