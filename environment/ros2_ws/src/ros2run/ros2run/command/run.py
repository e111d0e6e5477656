"""The command `ros2 run`."""

import shlex
from argparse import REMAINDER

from ros2cli.command import CommandExtension
from ros2pkg.api import PackageNotFound, package_name_completer

from ros2run.api import ExecutableNameCompleter, MultipleExecutables, get_executable_path, run_executable


class RunCommand(CommandExtension):
    """Run a package specific executable."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument(
            '--prefix',
            help='Command to run the executable with; in quotes if it has spaces, for example '
            "--prefix 'gdb -ex run --args'",
        )
        argument = parser.add_argument('package_name', help='Name of the package')
        argument.completer = package_name_completer
        argument = parser.add_argument('executable_name', help='Name of the executable')
        argument.completer = ExecutableNameCompleter(package_name_key='package_name')
        parser.add_argument('argv', nargs=REMAINDER, help='Everything else goes to the executable')

    def main(self, *, parser, args):
        """Run it and return its exit status."""
        try:
            path = get_executable_path(package_name=args.package_name, executable_name=args.executable_name)
        except PackageNotFound:
            return f"Package '{args.package_name}' not found"
        except MultipleExecutables as e:
            return 'Multiple executables found:' + ''.join(f'\n- {path}' for path in e.paths)
        if path is None:
            return 'No executable found'
        try:
            prefix = shlex.split(args.prefix or '')
        except ValueError as e:
            return f"The passed prefix '{args.prefix}' is invalid: {e}"
        try:
            return run_executable(path=path, argv=args.argv, prefix=prefix)
        except BrokenPipeError:  # of this process's own output, which the command line ends quietly
            raise
        except OSError as e:
            return f"Cannot run '{(prefix or [path])[0]}': {e.strerror}"
