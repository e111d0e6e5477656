"""The verb `ros2 bag info`."""

from ros2bag.api import STORAGES, check_path_exists, print_error
from ros2bag.verb import VerbExtension


class InfoVerb(VerbExtension):
    """Print information about a bag to the screen."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('bag_path', type=check_path_exists, help='Bag: a folder, or a .mcap or .db3 file')
        parser.add_argument('-s', '--storage', choices=STORAGES, default='', help='Accepted; the bag says it itself')
        parser.add_argument('-t', '--topic-name', action='store_true', help='Print only the names of the topics')
        parser.add_argument('-v', '--verbose', action='store_true', help='Accepted; everything is printed')

    def main(self, *, args):
        """Print what is known of the bag."""
        from rosbag2_py import BagError, Info

        try:
            metadata = Info().read_metadata(args.bag_path, args.storage)
        except BagError as error:
            return print_error(str(error))
        if args.topic_name:
            print('\n'.join(each.topic_metadata.name for each in metadata.topics_with_message_count))
        else:
            print(metadata)
