"""The command `ros2 daemon`: there is no daemon here, and its verbs say so."""

from ros2cli.command import CommandWithVerbs
from ros2cli.verb import VerbExtension

_NOT_RUNNING = 'The daemon is not running'


class DaemonCommand(CommandWithVerbs):
    """Various daemon related sub-commands."""

    VERB_GROUP = 'ros2cli.daemon.verb'


class StatusVerb(VerbExtension):
    """Output the status of the daemon."""

    def main(self, *, args):
        """Print it."""
        print(_NOT_RUNNING)


class StopVerb(VerbExtension):
    """Stop the daemon if it is running."""

    def main(self, *, args):
        """Print that it does not run."""
        print(_NOT_RUNNING)


class StartVerb(VerbExtension):
    """Start the daemon if it isn't running."""

    def main(self, *, args):
        """Print that none is needed."""
        print('No daemon is started: here each command asks the graph by itself')
