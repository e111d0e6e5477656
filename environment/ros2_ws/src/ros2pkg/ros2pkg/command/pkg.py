"""The command `ros2 pkg`."""

from ros2cli.command import CommandWithVerbs


class PkgCommand(CommandWithVerbs):
    """Various package related sub-commands."""

    VERB_GROUP = 'ros2pkg.verb'
