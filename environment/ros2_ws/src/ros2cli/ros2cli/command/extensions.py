"""The commands `ros2 extension_points` and `ros2 extensions`: which plug-ins of the ros2 command are installed."""

from importlib import metadata
from typing import Any

from ros2cli.command import CommandExtension
from ros2cli.entry_points import EXTENSION_POINT_GROUP_NAME, get_all_entry_points, get_entry_points, get_first_line_doc


class _Listing(CommandExtension):
    """What both commands share: their options, and how an entry point is shown."""

    WHAT = ''
    GOOD, BAD, GAP = '', '', ''  # what stands before a line of an entry point, and before its name

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument(
            '--all', '-a', action='store_true', help=f'Also show {self.WHAT} that cannot be used, after a dash'
        )
        parser.add_argument('--verbose', '-v', action='store_true', help=f'Show more about each of the {self.WHAT}')

    def show(self, args, entry_point: metadata.EntryPoint, facts: list[str], thing: Any, error: Any) -> None:
        """Print an entry point; one with an error only if all are asked for."""
        if error is not None and not args.all:
            return
        prefix, gap = (self.GOOD if error is None else self.BAD), self.GAP
        print(f'{prefix}{gap}{entry_point.name}:', get_first_line_doc(thing))
        known = [f'module_name: {entry_point.module}', f'attributes: {entry_point.attr}', *facts]
        reason = [] if error is None else [f'reason: {error}']
        for fact in (known if args.verbose else []) + reason:
            print(f'{prefix}   {fact}')


class ExtensionPointsCommand(_Listing):
    """List extension points."""

    WHAT = 'extension points'
    GOOD, BAD, GAP = '', '- ', ''

    def main(self, *, parser, args):
        """Print one line for each."""
        for _, entry_point in sorted(get_entry_points(EXTENSION_POINT_GROUP_NAME).items()):
            point, error, facts = None, None, []
            try:
                point = entry_point.load()
            except Exception as raised:  # one broken plug-in must not take the others down
                error = raised
            if hasattr(point, 'EXTENSION_POINT_VERSION'):
                facts = [f'version: {point.EXTENSION_POINT_VERSION}']
            self.show(args, entry_point, facts, point, error)


class ExtensionsCommand(_Listing):
    """List extensions."""

    WHAT = 'extensions'
    GOOD, BAD, GAP = ' ', '-', ' '

    def main(self, *, parser, args):
        """Print each group with its extensions."""
        for group, entry_points in sorted(get_all_entry_points().items()):
            print(group)
            for _, (distribution, entry_point) in sorted(entry_points.items()):
                extension, error = None, None
                try:
                    extension = entry_point.load()
                    extension()
                except Exception as raised:  # one broken plug-in must not take the others down
                    error = raised
                facts = [f'distribution: {distribution.name} {distribution.version}']
                self.show(args, entry_point, facts, extension, error)
