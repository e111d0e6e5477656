"""The extension point for verbs of this command."""

from ros2cli.verb import VerbExtension as _VerbExtension


class VerbExtension(_VerbExtension):
    """Base class of the verbs; an entry point of the group `ros2node.verb` names each."""
