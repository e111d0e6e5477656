"""The verb `ros2 service info`."""

from ros2cli.node.arguments import add_arguments

from ros2service.api import ServiceNameCompleter, get_service_names_and_types
from ros2service.verb import VerbExtension


class InfoVerb(VerbExtension):
    """Print information about a service."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('service_name', help='Name of the service, for example /add_two_ints')
        argument.completer = ServiceNameCompleter(include_hidden_services_key='include_hidden_services')

    def main(self, *, args):
        """Print the type and how many clients and servers there are."""
        from ros2cli.node.strategy import NodeStrategy

        name = args.service_name
        with NodeStrategy(args) as node:
            types = dict(get_service_names_and_types(node=node, include_hidden_services=True)).get(name)
            if types is None:
                return f"Unknown service '{name}'"
            print(f'Type: {types[0] if len(types) == 1 else types}')
            print(f'Clients count: {node.count_clients(name)}')
            print(f'Services count: {node.count_services(name)}')
