"""Whether a .msg, .srv or .action file can be read: rosidl's parser, line by line, and its reasons in plain words."""

import contextlib
import io
import re
from pathlib import PurePosixPath

PARTS = {'.msg': ('message',), '.srv': ('request', 'response'), '.action': ('goal', 'result', 'feedback')}
_DIVIDES = '---'


def mistake(path: str, text: str) -> tuple[str, int] | None:
    """What is wrong with the text of an interface file, and in which line (from 1; 0: in none of them)."""
    suffix = PurePosixPath(path).suffix
    lines = text.splitlines()
    if not any(line.partition('#')[0].strip() for line in lines):
        return None  # a .msg may be empty, and the others are not written yet
    names: dict[type, set] = {}
    for number, line in enumerate(lines, 1):
        if line == _DIVIDES:
            names = {}
        elif line.strip() and not line.strip().strip('-'):
            return f'`{_DIVIDES}` is three hyphens, and nothing else stands in its line, not even a blank', number
        elif found := _in_line(line, names):
            return found, number
    dividing, parts = lines.count(_DIVIDES), PARTS[suffix]
    if dividing + 1 == len(parts):
        return None
    needed = f'{len(parts) - 1} line{"s" if len(parts) > 2 else ""} `{_DIVIDES}`' if parts[1:] else f'no `{_DIVIDES}`'
    return f'a {suffix} file has {needed} ({", ".join(parts)}), and here are {dividing}', 0


def _in_line(line: str, names: dict[type, set]) -> str:
    """Why a line cannot be read; '' if it can. `names`: those of this part so far, which get those of the line."""
    from rosidl_adapter import parser

    with contextlib.redirect_stderr(io.StringIO()):  # it prints what it also raises
        try:
            made = parser.parse_message_string('package', 'Name', line)
        except parser.InvalidFieldDefinition:
            return 'a line has a type and a name, such as `float32 speed`'
        except parser.InvalidResourceName:
            return _wrong_type(line.split()[0])
        except NameError as error:
            return _wrong_name(str(error))
        except (parser.InvalidValue, TypeError, ValueError) as error:
            return str(error)
    for one in (*made.fields, *made.constants):
        known = names.setdefault(type(one), set())
        if one.name in known:
            return f'the name `{one.name}` is there twice'
        known.add(one.name)
    return ''


def _wrong_type(name: str) -> str:
    kind = re.sub(r'\[.*', '', name)
    if len(parts := kind.split('/')) == 3:
        return f'in an interface file the type is written `{parts[0]}/{parts[2]}`, without `/{parts[1]}/`'
    return (
        f'there is no type `{name}`: take a basic type such as `bool`, `int32`, `float64` or `string`, or '
        '`package_name/TypeName`'
    )


def _wrong_name(said: str) -> str:
    """In words what rosidl says with a regular expression."""
    found = re.match(r"'([^']*)' is an invalid (\w+) name", said)
    if found is None:
        return said
    name, kind = found.groups()
    if kind == 'constant':
        return (
            f'`{name}` is no name of a constant, and a line with `=` is one: it has capital letters, digits and single '
            '`_`. (A default value follows after a space, without `=`.)'
        )
    return (
        f'`{name}` is no name of a field: it begins with a small letter, then small letters, digits and single `_`. '
        '(A constant has `=` before its value.)'
    )
