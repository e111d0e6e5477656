"""The verb `ros2 bag burst`."""

from ros2bag.api import check_not_negative_int
from ros2bag.api.playing import add_bag_arguments, play_bag
from ros2bag.verb import VerbExtension


class BurstVerb(VerbExtension):
    """Burst data from a bag."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_bag_arguments(parser)
        parser.add_argument(
            '-n',
            '--num-messages',
            type=check_not_negative_int,
            default=0,
            help='Publish so many messages at once, then pause (default: 0, all of them)',
        )

    def main(self, *, args):
        """Publish messages as fast as possible; the keys play what is left."""

        def act(player):
            player.burst(args.num_messages)
            player.play_rest()  # from a pause; there is nothing left after all of them

        return play_bag(args, act, start_paused=True)
