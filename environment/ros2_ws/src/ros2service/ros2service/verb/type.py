"""The verb `ros2 service type`."""

from ros2cli.node.arguments import add_arguments

from ros2service.api import ServiceNameCompleter, get_service_names_and_types
from ros2service.verb import VerbExtension


class TypeVerb(VerbExtension):
    """Output a service's type."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('service_name', help='Name of the service, for example /add_two_ints')
        argument.completer = ServiceNameCompleter(include_hidden_services_key='include_hidden_services')

    def main(self, *, args):
        """Print the types, one a line; status 1 without a word if the service is unknown."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            services = get_service_names_and_types(node=node, include_hidden_services=args.include_hidden_services)
        types = dict(services).get(args.service_name)
        if types is None:
            return 1
        print('\n'.join(types))
        return 0
