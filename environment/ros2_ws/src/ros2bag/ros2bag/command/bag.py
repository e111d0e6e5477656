"""The command `ros2 bag`. Of ros2cli it needs what upstream's has, too: that one may be overlaid."""

from ros2cli.command import CommandExtension, add_subparsers_on_demand


class BagCommand(CommandExtension):
    """Various rosbag related sub-commands."""

    def add_arguments(self, parser, cli_name):
        """Add the verbs."""
        self._parser = parser
        add_subparsers_on_demand(parser, cli_name, '_verb', 'ros2bag.verb', required=False)

    def main(self, *, parser, args):
        """Call the verb, or print the help if none was given."""
        verb = getattr(args, '_verb', None)
        if verb is None:
            self._parser.print_help()
            return 0
        return verb.main(args=args)
