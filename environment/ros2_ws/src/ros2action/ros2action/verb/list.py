"""The verb `ros2 action list`."""

from ros2cli.node.arguments import add_arguments

from ros2action.api import get_action_names_and_types
from ros2action.verb import VerbExtension


class ListVerb(VerbExtension):
    """Output a list of action names."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('-t', '--show-types', action='store_true', help='Show the type of each action as well')
        parser.add_argument('-c', '--count-actions', action='store_true', help='Print only how many actions there are')

    def main(self, *, args):
        """Print the actions."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            actions = get_action_names_and_types(node=node)
        if args.count_actions:
            print(len(actions))
            return
        for name, types in actions:
            print(f'{name} [{", ".join(types)}]' if args.show_types else name)
