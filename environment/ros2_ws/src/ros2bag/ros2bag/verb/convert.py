"""The verb `ros2 bag convert`."""

import argparse

from ros2bag.api import input_bag, print_error
from ros2bag.verb import VerbExtension


class ConvertVerb(VerbExtension):
    """Given an input bag, write out a new bag with different settings."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument(
            '-i',
            '--input',
            required=True,
            action='append',
            nargs='+',
            metavar=('uri', 'storage_id'),
            help='Bag, and the kind of its files if it shall be checked; several bags with several -i',
        )
        parser.add_argument(
            '-o',
            '--output-options',
            required=True,
            metavar='FILE',
            help="YAML file: 'output_bags' is a list of bags, each with its 'uri' and, as names of rosbag2_py's "
            "StorageOptions and RecordOptions, what goes into it: 'all_topics: true', 'topics: [/chatter]' …",
        )

    def main(self, *, args):
        """Write the new bags."""
        from rosbag2_py import BagError, StorageOptions, bag_rewrite

        try:
            bag_rewrite([StorageOptions(*input_bag(*each)) for each in args.input], args.output_options)
        except (BagError, argparse.ArgumentTypeError) as error:
            return print_error(str(error))
