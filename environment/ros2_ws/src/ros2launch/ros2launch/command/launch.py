"""``ros2 launch``."""

from __future__ import annotations

import os
import sys

from ament_index_python.packages import PackageNotFoundError, get_package_prefix, get_packages_with_prefixes
from ros2cli.command import CommandExtension


def package_name_or_launch_file_completer(prefix: str, parsed_args, **kwargs) -> list[str]:
    """Complete packages, launch files of the directory typed so far, and directories."""
    completions = list(get_packages_with_prefixes())
    directory, start = os.path.split(prefix)
    try:
        entries = sorted(os.listdir(directory or os.curdir))
    except OSError:
        entries = []
    for name in entries:
        path = os.path.join(directory, name)
        if name.startswith(start) and os.path.isdir(path):
            completions.append(path + os.sep)
        elif name.endswith(('launch.py', 'launch.xml', 'launch.yaml', 'launch.yml')):
            completions.append(path)
    return completions


def _no_completion(prefix: str, parsed_args, **kwargs) -> list[str]:
    return []


def _complete_launch_file_name(prefix: str, parsed_args, **kwargs) -> list[str]:
    from ros2launch.api import LaunchFileNameCompleter

    return LaunchFileNameCompleter()(prefix, parsed_args, **kwargs)


class LaunchCommand(CommandExtension):
    """Run a launch file."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments of ``ros2 launch``."""
        _add_options_of_the_run(parser)
        _add_options_of_the_processes(parser)
        _add_what_is_launched(parser)

    def main(self, *, parser, args):
        """Run ``ros2 launch``; return the exit status, or the text of an error."""
        from ros2launch import api

        try:
            path, arguments = _find_launch_file(args, api)
            if args.show_all_subprocesses_output:
                os.environ['OVERRIDE_LAUNCH_PROCESS_OUTPUT'] = 'both'
            if args.launch_prefix:
                arguments = [f'launch-prefix:={args.launch_prefix}', *arguments]
            if args.launch_prefix_filter:
                arguments = [f'launch-prefix-filter:={args.launch_prefix_filter}', *arguments]
            if args.print:
                return api.print_a_launch_file(launch_file_path=path)
            if args.show_args:
                return api.print_arguments_of_launch_file(launch_file_path=path)
            return api.launch_a_launch_file(
                launch_file_path=path,
                launch_file_arguments=arguments,
                noninteractive=args.noninteractive,
                debug=args.debug,
            )
        except Exception as error:
            if args.debug:
                raise
            return str(error)


def _add_options_of_the_run(parser) -> None:
    parser.add_argument(
        '-n',
        '--noninteractive',
        default=not sys.stdin.isatty(),
        action='store_true',
        help='Run the launch system non-interactively, with no terminal associated',
    )
    parser.add_argument(
        '-d',
        '--debug',
        default=False,
        action='store_true',
        help='Put the launch system in debug mode, provides more verbose output.',
    )
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        '-p',
        '--print',
        '--print-description',
        default=False,
        action='store_true',
        help='Print the launch description to the console without launching it.',
    )
    group.add_argument(
        '-s',
        '--show-args',
        '--show-arguments',
        default=False,
        action='store_true',
        help='Show arguments that may be given to the launch file.',
    )


def _add_options_of_the_processes(parser) -> None:
    parser.add_argument(
        '-a',
        '--show-all-subprocesses-output',
        default=False,
        action='store_true',
        help="Show all launched subprocesses' output by overriding their output"
        ' configuration using the OVERRIDE_LAUNCH_PROCESS_OUTPUT envvar.',
    )
    parser.add_argument(
        '--launch-prefix',
        default=None,
        help='Prefix command, which should go before all executables. '
        'Command must be wrapped in quotes if it contains spaces '
        "(e.g. --launch-prefix 'xterm -e gdb -ex run --args').",
    )
    parser.add_argument(
        '--launch-prefix-filter',
        default=None,
        help='Regex pattern for filtering which executables the --launch-prefix is applied to '
        'by matching the executable name.',
    )


def _add_what_is_launched(parser) -> None:
    parser.add_argument(
        'package_name', help='Name of the ROS package which contains the launch file'
    ).completer = package_name_or_launch_file_completer
    parser.add_argument(
        'launch_file_name', nargs='?', help='Name of the launch file'
    ).completer = _complete_launch_file_name
    parser.add_argument(
        'launch_arguments',
        nargs='*',
        help="Arguments to the launch file; '<name>:=<value>' (for duplicates, last one wins)",
    ).completer = _no_completion


def _find_launch_file(args, api) -> tuple[str, list[str]]:
    """
    Return the path of the launch file that is meant, and the launch arguments.

    :raises RuntimeError: if there is none
    """
    first, second, rest = args.package_name, args.launch_file_name, args.launch_arguments
    if second is None or (os.path.isfile(first) and not _is_package(first)):
        if not os.path.isfile(first):
            raise RuntimeError('No launch file supplied')
        return first, [*([] if second is None else [second]), *rest]
    try:
        return api.get_share_file_path_from_package(package_name=first, file_name=second), rest
    except (PackageNotFoundError, ValueError) as error:
        raise RuntimeError(f"Package '{first}' not found: {error}") from error
    except (FileNotFoundError, api.MultipleLaunchFilesError) as error:
        raise RuntimeError(str(error)) from error


def _is_package(name: str) -> bool:
    try:
        get_package_prefix(name)
    except (PackageNotFoundError, ValueError):
        return False
    return True
