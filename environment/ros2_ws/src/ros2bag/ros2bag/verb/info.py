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
        parser.add_argument('-v', '--verbose', action='store_true', help='Print sizes and calls, too')
        parser.add_argument(
            '--sort', default='name', choices=('name', 'type', 'count'), help='Sort the topics (default: by name)'
        )

    def main(self, *, args):
        """Print what is known of the bag."""
        from rosbag2_py import BagError, Info

        if args.topic_name and args.verbose:
            print("Warning! You have set both the '-t' and '-v' parameters. The '-t' parameter will be ignored.")
        info = Info()
        try:
            metadata = info.read_metadata(args.bag_path, args.storage)
            if args.verbose:
                info.print_output_verbose(args.bag_path, metadata, args.sort)
            elif args.topic_name:
                info.print_output_topic_name_only(metadata, args.sort)
            else:
                info.print_output(metadata, args.sort)
        except BagError as error:
            return print_error(str(error))
