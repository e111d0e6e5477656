"""Answers that are files: below a line `%%answer NAME FILE` of a cell stands the text of that file.

A cell may hold several files, one below the other, and Python above the first one. What reads a cell as a program
reads `as_python` of it, where each file is a string with its name: `NAME = '…'`, as such answers were written before.
"""

import re
from collections.abc import Callable

MAGIC = '%%answer'
USAGE = f'{MAGIC} NAME FILE'
_LINE = re.compile(rf'{MAGIC}(?!\w)(.*)')
_ARGUMENTS = re.compile(r'([^\W\d]\w*)[ \t]+(\S.*)')


def as_python(source: str) -> str:
    """The Python program that a cell is: each file is assigned to its name, and each line keeps its number.

    A cell without files is returned as it is. A line `%%answer` that lacks its name or its file stays.
    """
    return rewritten(source, _assignment)


def files(source: str) -> list[tuple[str, str, str, int]]:
    """Name, file and text of each file in a cell, and the number of the line in which its text begins."""
    found = []

    def note(said: str, text: str, line: int) -> str:
        if named := arguments(said):
            found.append((*named, text, line))
        return ''

    rewritten(source, note)
    return found


def arguments(said: str) -> tuple[str, str] | None:
    """The name and the file of a line, from what stands behind `%%answer`; None if it is not these two."""
    match = _ARGUMENTS.fullmatch(said)
    return (match[1], match[2]) if match else None


def rewritten(source: str, statement: Callable[[str, str, int], str | None]) -> str:
    """The cell with a statement in place of each file, and empty lines in place of the file's text.

    `statement` gets what stands behind `%%answer`, the text, and the number of the line in which it begins; if it
    returns None, this file stays as it is. Another cell magic, such as `%%bash`, has the whole cell.
    """
    if MAGIC not in source:
        return source
    lines = source.split('\n')
    starts = [number for number, line in enumerate(lines) if _LINE.fullmatch(line)]
    first = next((number for number, line in enumerate(lines) if line.strip()), 0)
    if not starts or lines[first].startswith('%%') and first not in starts:
        return source
    for start, end in zip(starts, [*starts[1:], len(lines)], strict=True):
        match = _LINE.fullmatch(lines[start])
        begin, text = _text(lines, start + 1, end)
        made = statement(match[1].strip(' \t\r') if match else '', text, begin + 1)
        if made is not None:
            lines[start:end] = [made, *[''] * (end - start - 1)]
    return '\n'.join(lines)


def _assignment(said: str, text: str, line: int) -> str | None:
    named = arguments(said)
    return f'{named[0]} = {text!r}' if named else None


def _text(lines: list[str], begin: int, end: int) -> tuple[int, str]:
    """Where the text in these lines begins, and the text without the empty lines around it."""
    while begin < end and not lines[begin].strip(' \t'):
        begin += 1
    while begin < end and not lines[end - 1].strip(' \t'):
        end -= 1
    return begin, ''.join(f'{line}\n' for line in lines[begin:end])
