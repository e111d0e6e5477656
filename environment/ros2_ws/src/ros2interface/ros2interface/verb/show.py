"""The verb `ros2 interface show`."""

import sys

from ros2interface.api import type_completer
from ros2interface.verb import VerbExtension


class ShowVerb(VerbExtension):
    """Output the interface definition."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        self._parser = parser
        comments = parser.add_mutually_exclusive_group()
        comments.add_argument(
            '--all-comments', action='store_true', help='Print the comments of nested interfaces as well'
        )
        comments.add_argument('--no-comments', action='store_true', help='Print neither comments nor empty lines')
        argument = parser.add_argument(
            'type',
            help="Full name of the interface, for example std_msgs/msg/String; '-' reads it from standard input, for "
            'example ros2 topic type /chatter | ros2 interface show -',
        )
        argument.completer = type_completer

    def main(self, *, args):
        """Print the definition; the fields of a nested interface follow its field, one tab further in."""
        name = args.type
        if name == '-':
            if sys.stdin.isatty():
                self._parser.error('expected stdin pipe')
            name = sys.stdin.readline().strip()
        if not name:
            self._parser.error('the passed value is empty')
        try:
            _show(name, comments=not args.no_comments, nested_comments=args.all_comments, indentation='')
        except (LookupError, ValueError) as e:
            return str(e)


def _show(name, *, comments, nested_comments, indentation):
    from rosidl_runtime_py import get_interface_path

    if name.count('/') != 2:
        raise ValueError(f"Invalid name '{name}'. Expected three parts separated by '/'")
    with open(get_interface_path(name), encoding='utf-8') as definition:
        lines = definition.read().splitlines()
    for line in lines:
        text = line.rstrip() if comments else _without_comment(line)
        if text or comments:
            print(f'{indentation}{text}' if text else '')
        nested = _nested_type(line, name.partition('/')[0])
        if nested:
            _show(nested, comments=nested_comments, nested_comments=nested_comments, indentation=indentation + '\t')


def _nested_type(line, package):
    """Return the full name of the message that a line's field holds, or None."""
    from rosidl_adapter.parser import InvalidSpecification, parse_message_string

    if line.strip() in ('', '---'):
        return None
    try:
        fields = parse_message_string(package, 'Line', line).fields
    except (InvalidSpecification, ValueError):  # a line of an .idl file
        return None
    if not fields or not fields[0].type.pkg_name:
        return None
    return f'{fields[0].type.pkg_name}/msg/{fields[0].type.type}'


def _without_comment(line):
    """Return the line up to a # that is not part of a string. A lone # stays, as with stock: it has no text."""
    if line.strip() == '#':
        return line.rstrip()
    quote = ''
    for position, character in enumerate(line):
        if quote:
            quote = '' if character == quote else quote
        elif character in '\'"':
            quote = character
        elif character == '#':
            return line[:position].rstrip()
    return line.rstrip()
