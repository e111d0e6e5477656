"""The command `ros2 interface`."""

from ros2cli.command import CommandWithVerbs


class InterfaceCommand(CommandWithVerbs):
    """Show information about ROS interfaces."""

    VERB_GROUP = 'ros2interface.verb'
