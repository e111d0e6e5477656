"""The verb `ros2 service list`."""

import argparse

from ros2cli.node.arguments import add_arguments

from ros2service.api import get_service_names_and_types
from ros2service.verb import VerbExtension


class ListVerb(VerbExtension):
    """Output a list of available services."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('-t', '--show-types', action='store_true', help='Show the type of each service as well')
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
        """Print the services."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            services = get_service_names_and_types(node=node, include_hidden_services=args.include_hidden_services)
        if args.count_services:
            print(len(services))
            return
        for name, types in services:
            print(f'{name} [{", ".join(types)}]' if args.show_types else name)
