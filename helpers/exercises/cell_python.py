"""A notebook's cell as Python: without the magics and command lines that only a notebook knows."""

import ast
import re
from functools import lru_cache

from helpers.exercises import file_answers
from helpers.exercises.notebooks import NotebookCell

# For a stripped line, so that matching takes time in proportion to the line's length.
_MAGIC = re.compile(r'%(?!%)|[!?]|[\w., ()\[\]]+=\s*(%\w|!)|.*\?$')
_TIMED = re.compile(r'%time\s+(.+)')  # a line magic that runs its line as Python all the same
_MOST_PARSED = 4_000_000  # characters, to find the command lines of one cell
_RUNS = re.compile(r'\s*%%(?:time|capture|prun)\b[^\n]*\n')  # a cell magic that runs the cell as Python all the same
MAX_NESTING = 300  # of a program's syntax tree: what walks it recursively must not run out of stack


@lru_cache(maxsize=512)
def as_python(cell: NotebookCell) -> str:
    """A cell as Python; as it is, without its magics, if it is not Python."""
    text = below_magics(file_answers.as_python(cell.source))
    return text if syntax_tree(text) is not None else without_commands(text, [])


def below_magics(text: str) -> str:
    """A cell without the cell magics above it that run it as Python all the same; its lines keep their numbers."""
    for _ in range(3):  # one within the other
        if head := _RUNS.match(text):
            text = '\n' * head[0].count('\n') + text[head.end() :]
    return text


def without_commands(text: str, commands: list[tuple[int, str]]) -> str:
    """A cell in which the command lines of notebooks, which are not Python, do nothing. Other lines stay in place.

    Only where Python cannot read a line is it looked at: what stands in a string is no command.

    :param commands: is given the lines that are left out, with their numbers.
    """
    lines = text.split('\n')
    for _ in range(min(len(lines), _MOST_PARSED // (len(text) + 1))):
        try:
            ast.parse('\n'.join(lines))
            break
        except SyntaxError as error:
            number = (error.lineno or 1) - 1
        except (ValueError, RecursionError, MemoryError):
            break
        line = lines[number].strip() if number < len(lines) else ''
        if not _MAGIC.match(line):
            break
        commands.append((number + 1, line))
        timed = _TIMED.fullmatch(line)
        statement = timed[1] if timed and syntax_tree(timed[1]) is not None else 'pass'
        goes_on = lines[number].rstrip().endswith('\\')
        lines[number] = lines[number][: len(lines[number]) - len(lines[number].lstrip())] + statement
        while goes_on and number + 1 < len(lines):
            number += 1
            goes_on = lines[number].rstrip().endswith('\\')
            lines[number] = ''
    return '\n'.join(lines)


def syntax_tree(text: str) -> ast.Module | None:
    """The syntax tree of a text or of a cell; None if it is not Python, or nested too deeply."""
    try:
        tree = ast.parse(file_answers.as_python(text))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    return tree if nesting(tree) <= MAX_NESTING else None


def nesting(tree: ast.AST) -> int:
    """How deep a syntax tree is."""
    depth, level = 0, [tree]
    while level:
        depth += 1
        level = [child for node in level for child in ast.iter_child_nodes(node)]
    return depth
