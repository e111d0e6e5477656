"""The extension point for verbs of this command."""


class VerbExtension:
    """
    Base class of the verbs; an entry point of the group `ros2bag.verb` names each.

    The first line of its docstring is its line in the help.
    """

    NAME = None
    EXTENSION_POINT_VERSION = '0.1'

    def add_arguments(self, parser, cli_name):
        """Add the verb's arguments; `cli_name` is how it is called, for example `ros2 bag info`."""

    def main(self, *, args):
        """Do the work; return the exit status, or a text for stderr, which means 1."""
        raise NotImplementedError
