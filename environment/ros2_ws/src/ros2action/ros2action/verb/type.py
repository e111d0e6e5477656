"""The verb `ros2 action type`."""

from ros2cli.node.arguments import add_arguments

from ros2action.api import action_name_completer, get_action_names_and_types
from ros2action.verb import VerbExtension


class TypeVerb(VerbExtension):
    """Print a action's type."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('action_name', help='Name of the action, for example /fibonacci')
        argument.completer = action_name_completer

    def main(self, *, args):
        """Print the types, one a line; status 1 without a word if the action is unknown."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            types = dict(get_action_names_and_types(node=node)).get(args.action_name)
        if types is None:
            return 1
        print('\n'.join(types))
        return 0
