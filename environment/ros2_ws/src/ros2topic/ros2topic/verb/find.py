"""The verb `ros2 topic find`."""

import argparse

from ros2cli.node.arguments import add_arguments

from ros2topic.api import get_topic_names_and_types, message_type_completer
from ros2topic.verb import VerbExtension


class FindVerb(VerbExtension):
    """Output a list of available topics of a given type."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('topic_type', help='Type to look for, for example std_msgs/msg/String')
        argument.completer = message_type_completer
        parser.add_argument('-c', '--count-topics', action='store_true', help='Print only how many topics there are')
        parser.add_argument(
            '--include-hidden-topics', action='store_true', default=argparse.SUPPRESS, help='List hidden topics as well'
        )

    def main(self, *, args):
        """Print the names."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            topics = get_topic_names_and_types(node=node, include_hidden_topics=args.include_hidden_topics)
        names = [name for name, types in topics if args.topic_type in types]
        if args.count_topics:
            print(len(names))
        else:
            for name in names:
                print(name)
