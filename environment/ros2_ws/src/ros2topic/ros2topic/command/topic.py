"""The command `ros2 topic`."""

from argparse import ArgumentParser

from ros2cli.command import CommandWithVerbs


class TopicCommand(CommandWithVerbs):
    """Various topic related sub-commands."""

    VERB_GROUP = 'ros2topic.verb'

    def add_arguments(self, parser: ArgumentParser, cli_name: str) -> None:
        """Add what all verbs share, and the verbs."""
        parser.add_argument(
            '--include-hidden-topics',
            action='store_true',
            help='Also those of which a part of the name begins with an underscore',
        )
        super().add_arguments(parser, cli_name)
