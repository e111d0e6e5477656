"""The verb `ros2 interface proto`."""

from ros2interface.api import interface_to_yaml, type_completer
from ros2interface.verb import VerbExtension


class ProtoVerb(VerbExtension):
    """Output an interface prototype."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        argument = parser.add_argument('type', help='Full name of the interface, for example std_msgs/msg/String')
        argument.completer = type_completer
        parser.add_argument('--no-quotes', action='store_true', help='Print it without quotation marks around it')

    def main(self, *, args):
        """Print the fields with their defaults as YAML."""
        text = interface_to_yaml(args.type)
        print(text if args.no_quotes else f'"{text}"')
