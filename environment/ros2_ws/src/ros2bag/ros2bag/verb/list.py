"""The verb `ros2 bag list`."""

from ros2bag.verb import VerbExtension

# By kind: names, and for --verbose what each is, the class that does it, and the class that this is one of.
_PLUGINS = {
    'storage': (
        ('mcap', 'The MCAP file format', 'rosbag2_py.SequentialWriter', 'rosbag2_py.SequentialReader'),
        ('sqlite3', 'A SQLite database', 'rosbag2_py.SequentialWriter', 'rosbag2_py.SequentialReader'),
    ),
    'converter': (),
    'compression': (('zstd', 'Zstandard', 'rosbag2_py.SequentialCompressionWriter', 'rosbag2_py.SequentialWriter'),),
    'decompression': (('zstd', 'Zstandard', 'rosbag2_py.SequentialCompressionReader', 'rosbag2_py.SequentialReader'),),
}


class ListVerb(VerbExtension):
    """Print information about available plugins to the screen."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('plugin_type', choices=_PLUGINS, help='What kind of plugins to list')
        parser.add_argument('--verbose', action='store_true', help='Say of each what it is')

    def main(self, *, args):
        """List what there is; everything is built in."""
        if args.verbose:
            print(f'available {args.plugin_type} plugins are:')
        for name, description, kind, base in _PLUGINS[args.plugin_type]:
            print(f'name: {name}' if args.verbose else name)
            if args.verbose:
                print(f'\t{description}\n\ttype: {kind}\n\tbase_class: {base}')
