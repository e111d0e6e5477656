"""The command `ros2 param`."""

from ros2cli.command import CommandWithVerbs


class ParamCommand(CommandWithVerbs):
    """Various param related sub-commands."""

    VERB_GROUP = 'ros2param.verb'
