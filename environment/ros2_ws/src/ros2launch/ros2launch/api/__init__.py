"""What the launch command is made of; other programs may use it, too."""

from __future__ import annotations

import os
import pathlib

import launch
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from launch.frontend import Parser
from launch.launch_description_sources import (
    AnyLaunchDescriptionSource,
    InvalidLaunchFileError,
    InvalidPythonLaunchFileError,
    get_launch_description_from_any_launch_file,
)

__all__ = [
    'InvalidLaunchFileError',
    'InvalidPythonLaunchFileError',
    'LaunchFileNameCompleter',
    'MultipleLaunchFilesError',
    'get_launch_file_paths',
    'get_share_file_path_from_package',
    'is_launch_file',
    'launch_a_launch_file',
    'parse_launch_arguments',
    'print_a_launch_file',
    'print_arguments_of_launch_description',
    'print_arguments_of_launch_file',
]


class MultipleLaunchFilesError(Exception):
    """Several launch files of the same name in one package; ``paths`` are they."""

    def __init__(self, message: str, paths: list[str]):
        super().__init__(message)
        self.paths = paths


def get_share_file_path_from_package(*, package_name: str, file_name: str) -> str:
    """
    Return the path of a file in a package's share directory, at any depth.

    :raises PackageNotFoundError: if there is no such package
    :raises FileNotFoundError: if it has no such file
    :raises MultipleLaunchFilesError: if it has several
    """
    share = get_package_share_directory(package_name)
    paths = [os.path.join(root, file_name) for root, _, files in os.walk(share) if file_name in files]
    if not paths:
        raise FileNotFoundError(
            f"file '{file_name}' was not found in the share directory of package '{package_name}' which is at '{share}'"
        )
    if len(paths) > 1:
        listed = ', '.join(f"'{path}'" for path in sorted(paths))
        raise MultipleLaunchFilesError(
            f"file '{file_name}' was found more than once in the share directory of package '{package_name}': "
            f'[{listed}]',
            paths,
        )
    return paths[0]


def is_launch_file(path: str | os.PathLike) -> bool:
    """Return True for a file whose name ends as that of a launch file."""
    return str(path).endswith(_endings()) and os.path.isfile(path)


def get_launch_file_paths(*, path: str) -> list[str]:
    """Return the launch files in a directory and below."""
    return sorted(str(found) for found in pathlib.Path(path).rglob('*launch.*') if is_launch_file(found))


def _endings() -> tuple[str, ...]:
    """Return what the names of launch files end with."""
    return ('launch.py', *sorted(Parser.get_file_extensions_from_parsers()))


def parse_launch_arguments(launch_arguments: list[str]) -> list[tuple[str, str]]:
    """
    Return the names and values of ``name:=value`` words; of several of one name the last counts.

    :raises RuntimeError: for a word of another form
    """
    parsed = {}
    for argument in launch_arguments:
        name, found, value = argument.partition(':=')
        # Upstream refuses "name:=", too: an empty value is written as "name:=''" in the shell's own quotes.
        if not found or not name or (not value and argument.count(':=') == 1):
            raise RuntimeError(f"malformed launch argument '{argument}', expected format '<name>:=<value>'")
        parsed[name] = value
    return list(parsed.items())


def print_a_launch_file(*, launch_file_path: str) -> None:
    """Print what a launch file describes, without launching it."""
    description = get_launch_description_from_any_launch_file(launch_file_path)
    print(launch.LaunchIntrospector().format_launch_description(description))


def print_arguments_of_launch_file(*, launch_file_path: str) -> None:
    """Print the arguments that a launch file declares."""
    print_arguments_of_launch_description(
        launch_description=get_launch_description_from_any_launch_file(launch_file_path)
    )


def print_arguments_of_launch_description(*, launch_description: launch.LaunchDescription) -> None:
    """Print the arguments that a launch description declares."""
    arguments = launch_description.get_launch_arguments()
    print("Arguments (pass arguments as '<name>:=<value>'):")
    for argument in arguments:
        # Not public, but the same in upstream's launch, whose own command reads it, too.
        star = '*' if argument._conditionally_included else ''
        print(f"\n    '{argument.name}':{star}\n        {argument.description}")
        if argument.default_value is not None:
            default = ' + '.join(part.describe() for part in argument.default_value)
            print(f'        (default: {default})')
    if not arguments:
        print('\n  No arguments.')
    elif any(argument._conditionally_included for argument in arguments):
        print('\n* argument(s) which are only used if specific conditions occur')


def launch_a_launch_file(
    *, launch_file_path: str, launch_file_arguments: list[str], noninteractive: bool = False, debug: bool = False
) -> int:
    """
    Launch a launch file and return the exit status.

    :raises RuntimeError: for malformed arguments
    """
    arguments = parse_launch_arguments(launch_file_arguments)
    service = launch.LaunchService(argv=launch_file_arguments, noninteractive=noninteractive, debug=debug)
    # An include, because that tells the launch file where it is.
    include = launch.actions.IncludeLaunchDescription(
        AnyLaunchDescriptionSource(launch_file_path), launch_arguments=arguments
    )
    service.include_launch_description(launch.LaunchDescription([include]))
    return service.run()


class LaunchFileNameCompleter:
    """Completes the names of a package's launch files."""

    def __init__(self, *, package_name_key: str = 'package_name'):
        self._key = package_name_key

    def __call__(self, prefix: str, parsed_args, **kwargs) -> list[str]:
        try:
            share = get_package_share_directory(getattr(parsed_args, self._key))
        except (PackageNotFoundError, ValueError):
            return []
        return [os.path.basename(path) for path in get_launch_file_paths(path=share)]
