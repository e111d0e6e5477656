"""The verb `ros2 topic info`."""

from ros2cli.node.arguments import add_arguments

from ros2topic.api import TopicNameCompleter, get_topic_names_and_types
from ros2topic.verb import VerbExtension


class InfoVerb(VerbExtension):
    """Print information about a topic."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('topic_name', help='Name of the topic, for example /chatter')
        argument.completer = TopicNameCompleter(include_hidden_topics_key='include_hidden_topics')
        parser.add_argument(
            '--verbose',
            '-v',
            action='store_true',
            help='Show each publisher and subscription: its node, type, type hash, GID and quality of service',
        )

    def main(self, *, args):
        """Print the type, the counts and, if asked, every endpoint."""
        from ros2cli.node.strategy import NodeStrategy

        name = args.topic_name
        with NodeStrategy(args) as node:
            types = dict(get_topic_names_and_types(node=node, include_hidden_topics=True)).get(name)
            if types is None:
                return f"Unknown topic '{name}'"
            publishers = node.get_publishers_info_by_topic(name)
            subscriptions = node.get_subscriptions_info_by_topic(name)
        end = '\n\n' if args.verbose else '\n'
        print(f'Type: {types[0] if len(types) == 1 else types}', end=end)
        for title, endpoints in (('Publisher', publishers), ('Subscription', subscriptions)):
            print(f'{title} count: {len(endpoints)}', end=end)
            if args.verbose:
                for endpoint in endpoints:
                    print(endpoint, end=end)
