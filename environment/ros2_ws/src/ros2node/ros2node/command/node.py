"""The command `ros2 node`."""

from ros2cli.command import CommandWithVerbs


class NodeCommand(CommandWithVerbs):
    """Various node related sub-commands."""

    VERB_GROUP = 'ros2node.verb'
