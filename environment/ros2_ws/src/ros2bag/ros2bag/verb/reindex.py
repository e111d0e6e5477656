"""The verb `ros2 bag reindex`."""

from ros2bag.api import STORAGES, check_path_exists, print_error
from ros2bag.verb import VerbExtension


class ReindexVerb(VerbExtension):
    """Reconstruct metadata file for a bag."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('bag_path', type=check_path_exists, help='Folder of the bag')
        parser.add_argument(
            '-s', '--storage', choices=STORAGES, default='', help='Kind of its files, if there are both'
        )

    def main(self, *, args):
        """Make metadata.yaml anew; an MCAP file without an end gets one."""
        from rclpy.logging import get_logger
        from rosbag2_py import BagError, Reindexer, StorageOptions

        logger = get_logger('rosbag2_cpp')
        logger.info('Beginning reindexing bag in directory: ' + args.bag_path)
        try:
            Reindexer().reindex(StorageOptions(args.bag_path, args.storage))
        except BagError as error:
            return print_error(str(error))
        logger.info('Reindexing complete.')
