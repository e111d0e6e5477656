"""The verb `ros2 topic type`."""

from ros2cli.node.arguments import add_arguments

from ros2topic.api import TopicNameCompleter, get_topic_names_and_types
from ros2topic.verb import VerbExtension


class TypeVerb(VerbExtension):
    """Print a topic's type."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_arguments(parser)
        argument = parser.add_argument('topic_name', help='Name of the topic, for example /chatter')
        argument.completer = TopicNameCompleter(include_hidden_topics_key='include_hidden_topics')

    def main(self, *, args):
        """Print the types, one a line; status 1 without a word if the topic is unknown."""
        from ros2cli.node.strategy import NodeStrategy

        with NodeStrategy(args) as node:
            topics = get_topic_names_and_types(node=node, include_hidden_topics=args.include_hidden_topics)
        types = dict(topics).get(args.topic_name)
        if types is None:
            return 1
        print('\n'.join(types))
        return 0
