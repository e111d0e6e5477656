"""The verb `ros2 topic list`."""

import argparse

from ros2cli.node.arguments import add_arguments

from ros2topic.api import get_topic_names_and_types
from ros2topic.verb import VerbExtension


class ListVerb(VerbExtension):
    """Output a list of available topics."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        parser.add_argument('-t', '--show-types', action='store_true', help='Show the type of each topic as well')
        parser.add_argument('-c', '--count-topics', action='store_true', help='Print only how many topics there are')
        # The command has it too; without a default of its own, this one does not undo that one.
        parser.add_argument(
            '--include-hidden-topics', action='store_true', default=argparse.SUPPRESS, help='List hidden topics as well'
        )
        parser.add_argument(
            '-v', '--verbose', action='store_true', help='List published and subscribed topics apart, with counts'
        )

    def main(self, *, args):
        """Print the topics."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            topics = get_topic_names_and_types(node=node, include_hidden_topics=args.include_hidden_topics)
            if args.verbose:
                counts = {name: (node.count_publishers(name), node.count_subscribers(name)) for name, _ in topics}
        if args.count_topics:
            print(len(topics))
        elif args.verbose:
            if topics:
                self._print_counted('Published', 'publisher', [(n, t, counts[n][0]) for n, t in topics])
                self._print_counted('Subscribed', 'subscriber', [(n, t, counts[n][1]) for n, t in topics])
        else:
            for name, types in topics:
                print(f'{name} [{", ".join(types)}]' if args.show_types else name)

    def _print_counted(self, title, kind, topics):
        print(f'{title} topics:')
        for name, types, count in topics:
            if count:
                print(f' * {name} [{", ".join(types)}] {count} {kind}{"s" if count > 1 else ""}')
        print()
