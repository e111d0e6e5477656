"""The command `ros2 lifecycle`."""

from ros2cli.command import CommandWithVerbs


class LifecycleCommand(CommandWithVerbs):
    """Various lifecycle related sub-commands."""

    VERB_GROUP = 'ros2lifecycle.verb'
