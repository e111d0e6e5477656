"""The base class of the verbs of all commands."""

import argparse
from typing import Any

from ros2cli.plugin_system import PLUGIN_SYSTEM_VERSION, satisfies_version


class VerbExtension:
    """
    Base class of a verb, `ros2 <command> <NAME> …`; an entry point of the group `<package>.verb` names it.

    The first line of its docstring is its line in the help.
    """

    NAME: str | None = None
    EXTENSION_POINT_VERSION = '0.1'

    def __init__(self) -> None:
        """Check that the plug-in interface is the one this class was written for."""
        satisfies_version(PLUGIN_SYSTEM_VERSION, '^0.1')

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        """Add the verb's arguments; `cli_name` is how it is called, for example `ros2 topic list`."""

    def main(self, *, args: argparse.Namespace) -> Any:
        """Do the work; return the exit status, or a text for stderr, which means 1."""
        raise NotImplementedError
