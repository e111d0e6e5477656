"""Commands and verbs as argparse sub-parsers, each loaded only when it is named or listed in a help text."""

import argparse
from collections.abc import Callable, Collection
from importlib import metadata
from typing import Any

from ros2cli.entry_points import get_entry_points, get_first_line_doc, load_entry_point
from ros2cli.plugin_system import PLUGIN_SYSTEM_VERSION, satisfies_version


class CommandExtension:
    """
    Base class of a command, `ros2 <NAME> …`; an entry point of the group `ros2cli.command` names it.

    The first line of its docstring is its line in `ros2 --help`.
    """

    NAME: str | None = None
    EXTENSION_POINT_VERSION = '0.1'

    def __init__(self) -> None:
        """Check that the plug-in interface is the one this class was written for."""
        satisfies_version(PLUGIN_SYSTEM_VERSION, '^0.1')

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        """Add the command's arguments; `cli_name` is how it is called, for example `ros2 topic`."""

    def main(self, *, parser: argparse.ArgumentParser, args: argparse.Namespace) -> Any:
        """Do the work; return the exit status, or a text for stderr, which means 1."""
        raise NotImplementedError


class CommandWithVerbs(CommandExtension):
    """A command that only has verbs; the verbs are entry points of the group VERB_GROUP."""

    VERB_GROUP = ''

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        """Add the verbs."""
        self._parser = parser
        add_subparsers_on_demand(parser, cli_name, '_verb', self.VERB_GROUP, required=False)

    def main(self, *, parser: argparse.ArgumentParser, args: argparse.Namespace) -> Any:
        """Call the verb, or print the help if none was given."""
        verb = getattr(args, '_verb', None)
        if verb is None:
            self._parser.print_help()
            return 0
        return verb.main(args=args)


class LazyParser(argparse.ArgumentParser):
    """A parser that runs `before_help` before it prints its help."""

    before_help: Callable[[], None] | None = None

    def format_help(self) -> str:
        """Return the help text."""
        if self.before_help is not None:
            self.before_help()
        return super().format_help()


class _LazyParsers(dict[str, argparse.ArgumentParser]):
    """The sub-parsers by name; getting one fills it first. Listing the names loads nothing."""

    def __init__(self, fill: Callable[[str, argparse.ArgumentParser], None]) -> None:
        super().__init__()
        self._fill = fill

    def __getitem__(self, name: str) -> argparse.ArgumentParser:
        parser = super().__getitem__(name)
        self._fill(name, parser)
        return parser


def add_subparsers_on_demand(
    parser: argparse.ArgumentParser,
    cli_name: str,
    dest: str,
    group_name: str,
    hide_extensions: Collection[str] = (),
    required: bool = True,
    argv: Any = None,
) -> Any:
    """
    Add a sub-parser for each plug-in of a group.

    :param dest: attribute of the parsed arguments that will hold the chosen plug-in.
    :param hide_extensions: names left out of the help.
    :param argv: unused; upstream's signature.
    """
    entry_points = get_entry_points(group_name)
    metavar = f'Call `{cli_name} <command> -h` for more detailed usage.'
    # A description must be given now for the help to have the section; its text comes when it is asked for.
    action = parser.add_subparsers(title='Commands', description=' ', metavar=metavar, parser_class=LazyParser)
    # A name that no argument can have, yet readable in an error message.
    action.dest = ' ' + dest.lstrip('_')
    action.required = required
    loaded: dict[str, Any] = {}

    def fill(name: str, subparser: argparse.ArgumentParser) -> None:
        if name in loaded:
            return
        extension = loaded[name] = load_entry_point(entry_points[name])
        if extension is None:
            subparser.exit(1)
        subparser.set_defaults(**{dest: extension})
        subparser.description = get_first_line_doc(extension)
        extension.add_arguments(subparser, f'{cli_name} {name}')

    action._name_parser_map = action.choices = _LazyParsers(fill)
    for name in sorted(entry_points):
        action.add_parser(name, formatter_class=argparse.RawDescriptionHelpFormatter)

    def describe() -> None:
        shown = {name: point for name, point in entry_points.items() if name not in hide_extensions}
        parser._subparsers.description = _describe(shown)

    if isinstance(parser, LazyParser):
        parser.before_help = describe
    else:
        describe()
    return action


def _describe(entry_points: dict[str, metadata.EntryPoint]) -> str:
    width = max(map(len, entry_points), default=0)
    lines = []
    for name in sorted(entry_points):
        extension = load_entry_point(entry_points[name])
        if extension is not None:
            lines.append(f'{name.ljust(width)}  {get_first_line_doc(extension)}\n')
    return ''.join(lines)
