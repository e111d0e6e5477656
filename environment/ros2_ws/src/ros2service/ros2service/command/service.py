"""The command `ros2 service`."""

from argparse import ArgumentParser

from ros2cli.command import CommandWithVerbs


class ServiceCommand(CommandWithVerbs):
    """Various service related sub-commands."""

    VERB_GROUP = 'ros2service.verb'

    def add_arguments(self, parser: ArgumentParser, cli_name: str) -> None:
        """Add what all verbs share, and the verbs."""
        parser.add_argument(
            '--include-hidden-services',
            action='store_true',
            help='Also those of which a part of the name begins with an underscore',
        )
        super().add_arguments(parser, cli_name)
