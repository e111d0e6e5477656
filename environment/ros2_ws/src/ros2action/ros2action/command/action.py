"""The command `ros2 action`."""

from ros2cli.command import CommandWithVerbs


class ActionCommand(CommandWithVerbs):
    """Various action related sub-commands."""

    VERB_GROUP = 'ros2action.verb'
