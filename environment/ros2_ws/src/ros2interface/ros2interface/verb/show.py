"""The verb `ros2 interface show`."""

import sys
from pathlib import Path

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


class InterfaceTextLine:
    """
    A line of the definition of an interface.

    :param pkg_name: the package of the interface, where types without a package are looked for
    :param msg_name: the name of the interface
    :param line_text: the line
    """

    def __init__(self, pkg_name, msg_name, line_text):
        self.pkg_name, self.msg_name = pkg_name, msg_name
        self.text = line_text.rstrip()
        self.text_without_comment = self.text[: self._comment_position()].rstrip()

    def __str__(self):
        return self.text

    def _comment_position(self):
        """Return the position of the # that is not part of a string; without one, the end."""
        quote = ''
        for position, character in enumerate(self.text):
            if quote:
                quote = '' if character == quote else quote
            elif character in '\'"':
                quote = character
            elif character == '#':
                return position
        return len(self.text)

    def is_comment(self):
        """Return whether the line has nothing but a comment."""
        return self.text.lstrip().startswith('#')

    def is_trailing_comment(self):
        """Return whether a comment follows something else."""
        return not self.is_comment() and self.text_without_comment != self.text

    @property
    def nested_type(self):
        """The full name of the message that the line's field holds, or None."""
        from rosidl_adapter.parser import InvalidSpecification, parse_message_string

        if self.text.strip() in ('', '---'):
            return None
        try:
            fields = parse_message_string(self.pkg_name, self.msg_name, self.text).fields
        except (InvalidSpecification, ValueError):
            return None
        if not fields or not fields[0].type.pkg_name:
            return None
        return f'{fields[0].type.pkg_name}/msg/{fields[0].type.type}'


def _path_of(name):
    """Return the path of an interface's definition, which may be in a folder of any name, as `msg/common` is."""
    from ament_index_python import get_resource
    from rosidl_runtime_py import get_interface_path

    try:
        return get_interface_path(name)
    except LookupError:
        package, kind, interface = name.split('/')
        try:
            files, prefix = get_resource('rosidl_interfaces', package)
        except LookupError:
            files = ''
        for wanted in (f'{interface}.{kind}', f'{interface}.idl'):
            for file in map(Path, files.splitlines()):
                if file.name == wanted and (found := Path(prefix, 'share', package, file)).is_file():
                    return str(found)
        raise


def _show(name, *, comments, nested_comments, indentation):
    if name.count('/') != 2:
        raise ValueError(f"Invalid name '{name}'. Expected three parts separated by '/'")
    package, _, interface = name.split('/')
    path = _path_of(name)
    with open(path, encoding='utf-8') as definition:
        lines = [InterfaceTextLine(package, interface, line) for line in definition.read().splitlines()]
    for line in lines:
        text = line.text if comments else line.text_without_comment
        if text or comments:
            print(f'{indentation}{text}' if text else '')
        # What is defined in IDL only has another syntax.
        nested = None if path.endswith('.idl') else line.nested_type
        if nested:
            _show(nested, comments=nested_comments, nested_comments=nested_comments, indentation=indentation + '\t')
