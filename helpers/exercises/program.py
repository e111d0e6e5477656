"""From cells to the program that is run for one exercise.

The exercise's cell is taken whole. From the cells before it come only imports, functions, classes and constant
assignments: statements that only demonstrate something never run. The exercise's own cell must define the names that
the exercise asks for. Nothing is executed here.
"""

import ast
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import lru_cache

from helpers.exercises import file_answers
from helpers.exercises.manifest import Exercise, stub_digest
from helpers.exercises.notebooks import NotebookCell

HEADING = re.compile(r'#\s*Exercise\s+([0-9]{1,4}\.[0-9]{1,4})\b', re.IGNORECASE)
# For a stripped line, so that matching takes time in proportion to the line's length.
_MAGIC = re.compile(r'%(?!%)|[!?]|[\w., ()\[\]]+=\s*(%\w|!)|.*\?$')
_TIMED = re.compile(r'%time\s+(.+)')  # a line magic that runs its line as Python all the same
_MOST_PARSED = 4_000_000  # characters, to find the command lines of one cell
_RUNS = re.compile(r'\s*%%(?:time|capture|prun)\b[^\n]*\n')  # a cell magic that runs the cell as Python all the same
_LINE = re.compile(r'[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+')  # as Python counts lines
MAX_NESTING = 300  # of a program's syntax tree: what walks it recursively must not run out of stack
# Calls that make a constant when their arguments are constant.
_VALUE_TYPES = {'QoSProfile', 'Duration', 'Time'}


class InvalidExercise(Exception):
    """One exercise's cell is missing, doubled or unreadable; the message is for the learner."""


class NotAttempted(Exception):
    """The exercise's cell is still what the learner was given."""


@dataclass
class Program:
    """What the learner's process loads for one exercise."""

    exercise: Exercise
    cells: list[dict] = field(default_factory=list)  # label, source, line (of its beginning in the cell), required
    elsewhere: dict[str, str] = field(default_factory=dict)  # names that cells define which are not among them
    # For the learner: what was done with the cell; no mark depends on it.
    notes: list[str] = field(default_factory=list)

    @property
    def title(self) -> str:
        """How messages name it."""
        return f'Exercise {self.exercise.id}'

    def as_dict(self) -> dict:
        """The program as a JSON value."""
        return {'title': self.title, 'cells': self.cells, 'elsewhere': self.elsewhere, 'notes': self.notes}


def unsolved(exercise: str) -> str:
    """What is said of a cell that is still as it was given."""
    return f'Exercise {exercise} is not solved yet.'


def exercise_id(cell: NotebookCell) -> str | None:
    """The id in the cell's first line, `# Exercise 3.2: …`, or None."""
    first = next((line for line in _run_as_python(cell.source).splitlines() if line.strip()), '')
    match = HEADING.match(first.strip())
    return match[1] if match else None


def _run_as_python(text: str) -> str:
    """A cell without the cell magics above it that run it as Python all the same; its lines keep their numbers."""
    for _ in range(3):  # one within the other
        if head := _RUNS.match(text):
            text = '\n' * head[0].count('\n') + text[head.end() :]
    return text


def of_exercise(cells: list[NotebookCell], exercise: Exercise) -> list[NotebookCell]:
    """The cells that claim to be this exercise's, by heading or by id."""
    return [
        cell
        for cell in cells
        if exercise_id(cell) == exercise.id or (cell.id == exercise.cell_id and exercise_id(cell) is None)
    ]


def build(cells: list[NotebookCell], exercise: Exercise, notebook: Iterable[NotebookCell] = ()) -> Program:
    """Return the program for ``exercise`` from a notebook's code cells, in their order.

    ``notebook``: all cells of the notebook where ``cells`` are only those that were run: messages name what is missing.

    :raises InvalidExercise: its cell is missing, doubled, not Python, or lacks a required name.
    :raises NotAttempted: its cell is the unchanged stub.
    """
    cell = _only_cell(cells, exercise)
    commands: list[tuple[int, str]] = []
    own, tree = _parse_exercise(cell, exercise, commands)
    if exercise.is_stub(stub_digest(own)):
        raise NotAttempted(unsolved(exercise.id))
    if missing := [name for name in exercise.names if name not in defined(tree.body)]:
        own += _continued(cells, cell, missing)
        missing = [name for name in missing if name not in names_in(own)]
    if missing:
        there = sorted(name for name in defined(tree.body) if not name.startswith('_'))
        raise InvalidExercise(
            f'The cell of exercise {exercise.id} must define `{missing[0]}`'
            + (f'; it defines {", ".join(f"`{name}`" for name in there[:5])}.' if there else '.')
            + _on_lost_line(cell, exercise)
        )
    program = Program(exercise)
    for other in cells[: cells.index(cell)]:
        program.cells += [
            {'label': other.label, 'source': text, 'line': line, 'required': False} for line, text in definitions(other)
        ]
    program.notes = [_on_left_out(exercise, *command) for command in commands[:3]]
    program.cells.append({'label': cell.label, 'source': own, 'line': 1, 'required': True})
    have = {name for part in program.cells for name in names_in(part['source'])}
    for other in notebook:
        for name in {name for _, text in definitions(other) for name in names_in(text)} - have:
            program.elsewhere.setdefault(name, other.label)
    return program


def _only_cell(cells: list[NotebookCell], exercise: Exercise) -> NotebookCell:
    """The cell that holds the answer: of several that claim to be it, the one that is not a copy without an answer."""
    heading = f'# Exercise {exercise.id}: {exercise.title}'
    found = of_exercise(cells, exercise) or _with_heading_inside(cells, exercise)
    if not found:
        raise InvalidExercise(f'The cell of exercise {exercise.id} was not found: its first line must be `{heading}`.')
    answers = list({cell.source.strip(): cell for cell in found if _is_answer(cell, exercise)}.values())
    if len(found) > 1 and len(answers) != 1:
        numbers = ' and '.join(str(cell.number) for cell in found if cell.number)
        raise InvalidExercise(
            f'Exercise {exercise.id} is there {len(found)} times'
            + (f' (cells {numbers})' if numbers else '')
            + f': keep one cell that begins with `{heading}`.'
        )
    return found[0] if len(found) == 1 else answers[0]


def _is_answer(cell: NotebookCell, exercise: Exercise) -> bool:
    """Whether there is more in a cell than comments, and other things than what was given."""
    text = _run_as_python(cell.source)
    tree = syntax_tree(text)
    return tree is None or bool(tree.body) and not exercise.is_stub(stub_digest(text))


def _with_heading_inside(cells: list[NotebookCell], exercise: Exercise) -> list[NotebookCell]:
    """The cells that have the exercise's heading further down, and define its names: others were merged with it."""
    return [
        cell
        for cell in cells
        if any((match := HEADING.match(line)) and match[1] == exercise.id for line in cell.source.split('\n'))
        and set(exercise.names) <= names_in(cell.source)
    ]


def _continued(cells: list[NotebookCell], cell: NotebookCell, missing: list[str]) -> str:
    """The text of the cells directly below an exercise's one, as far as they have what is missing: it was split.

    Nothing, if another exercise or a check comes before.
    """
    text = ''
    for other in cells[cells.index(cell) + 1 :]:
        more = _run_as_python(file_answers.as_python(other.source))
        if exercise_id(other) is not None or syntax_tree(more) is None or re.search(r'^check\(', more, re.MULTILINE):
            return ''
        text += f'\n\n{more}'
        missing = [name for name in missing if name not in names_in(more)]
        if not missing:
            return text
    return ''


def _on_left_out(exercise: Exercise, number: int, line: str) -> str:
    return (
        f'Exercise {exercise.id}, line {number}: the notebook command `{line[:60]}` was left out, because only Python '
        'is tested. It is better off in a cell of its own.'
    )


def _on_lost_line(cell: NotebookCell, exercise: Exercise) -> str:
    """What to say where the names are those of files, and no line of the cell begins one."""
    if file_answers.MAGIC in cell.source or not all(name.isupper() for name in exercise.names):
        return ''
    if any(re.search(rf'^{name}\b', cell.source, re.MULTILINE) for name in exercise.names):
        return ''
    return (
        f' An answer that is a file stands below a line `{file_answers.MAGIC} {exercise.names[0]} FILE`. If you have '
        'deleted that line, bring it back with Ctrl+Z.'
    )


def names_in(text: str) -> set[str]:
    """The names that a text binds; none if it is not Python."""
    tree = syntax_tree(text)
    return defined(tree.body) if tree is not None else set()


def _parse_exercise(cell: NotebookCell, exercise: Exercise, commands: list[tuple[int, str]]) -> tuple[str, ast.Module]:
    """The Python program that an exercise's cell is, and its syntax tree.

    :param commands: is given the lines that were left out, with their numbers.
    """
    source = _without_commands(_run_as_python(file_answers.as_python(cell.source)), commands)
    try:
        tree = ast.parse(source)
        if _nesting(tree) > MAX_NESTING:
            raise InvalidExercise(f'Exercise {exercise.id}: the cell is nested too deeply to be read.')
        return source, tree
    except SyntaxError as error:
        lines = source.splitlines()
        for number, line in enumerate(lines, 1):
            if line.startswith(file_answers.MAGIC):
                raise InvalidExercise(
                    f'Exercise {exercise.id}, line {number}: `{line.strip()[:60]}` must be `{file_answers.USAGE}`: a '
                    'name, and where the file goes.'
                ) from None
            if line.lstrip()[:1] in ('%', '!', '?'):
                raise InvalidExercise(
                    f'Exercise {exercise.id}, line {number}: `{line.strip()[:60]}` is a notebook '
                    'command, not Python. Move it to a cell of its own.'
                ) from None
        text = lines[error.lineno - 1].strip()[:80] if error.lineno and error.lineno <= len(lines) else ''
        raise InvalidExercise(
            f'Exercise {exercise.id}, line {error.lineno}: Python cannot read `{text}` ({error.msg}).'
            + _on_lost_line(cell, exercise)
        ) from None
    except (ValueError, RecursionError, MemoryError):  # null bytes, very deep nesting
        raise InvalidExercise(f'Exercise {exercise.id}: Python cannot read the cell.') from None


@lru_cache(maxsize=512)
def definitions(cell: NotebookCell) -> tuple[tuple[int, str], ...]:
    """Imports, functions, classes and constant assignments of a cell; none if it is not Python.

    Each is its first line's number in the cell, so that line numbers in messages are the learner's, and its text.
    """
    text = _run_as_python(file_answers.as_python(cell.source))
    if text.lstrip().startswith('%%'):
        return ()
    tree = syntax_tree(text)
    if tree is None:
        text = _without_commands(text, [])
        tree = syntax_tree(text)
    if tree is None:
        return ()
    lines = _LINE.findall(text)
    found = []
    for node in tree.body:
        if _is_definition(node):
            first = min([node.lineno, *(d.lineno for d in getattr(node, 'decorator_list', ()))])
            part = lines[first - 1 : node.end_lineno]
            if len(part) == 1:  # a neighbour on the same line is cut off
                part = [part[0].encode()[node.col_offset : node.end_col_offset].decode()]
            found.append((first, ''.join(part).rstrip('\r\n') + '\n'))
    return tuple(found)


def _without_commands(text: str, commands: list[tuple[int, str]]) -> str:
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
    return tree if _nesting(tree) <= MAX_NESTING else None


def _nesting(tree: ast.AST) -> int:
    """How deep a syntax tree is."""
    depth, level = 0, [tree]
    while level:
        depth += 1
        level = [child for node in level for child in ast.iter_child_nodes(node)]
    return depth


def _is_definition(node: ast.stmt) -> bool:
    match node:
        case ast.Import() | ast.ImportFrom() | ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
            return True
        case ast.Assign(targets=targets, value=value):
            return all(map(_is_name, targets)) and _is_constant(value)
        case ast.AnnAssign(target=ast.Name(), value=value):
            return value is None or _is_constant(value)
    return False


def _is_name(target: ast.expr) -> bool:
    """Names that are bound: an attribute of an object is none, which a demonstration has made."""
    match target:
        case ast.Tuple(elts=parts) | ast.List(elts=parts):
            return all(map(_is_name, parts))
        case ast.Starred(value=part):
            return _is_name(part)
    return isinstance(target, ast.Name)


def _is_constant(node: ast.expr) -> bool:
    """A literal, names and attributes, arithmetic of these, or a QoSProfile, Duration or Time made of these."""
    match node:
        case ast.Constant() | ast.Name():
            return True
        case ast.Attribute(value=value) | ast.UnaryOp(operand=value) | ast.Starred(value=value):
            return _is_constant(value)
        case ast.BinOp(left=left, right=right):
            return _is_constant(left) and _is_constant(right)
        case ast.Subscript(value=value, slice=key):
            return _is_constant(value) and _is_constant(key)
        case ast.Tuple(elts=items) | ast.List(elts=items) | ast.Set(elts=items):
            return all(map(_is_constant, items))
        case ast.Dict(keys=keys, values=values):
            return all(_is_constant(item) for item in [*keys, *values] if item is not None)
        case ast.Lambda():
            return True
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name), args=args, keywords=keywords):
            return name in _VALUE_TYPES and all(map(_is_constant, [*args, *(keyword.value for keyword in keywords)]))
    return False


def defined(body: list[ast.stmt]) -> set[str]:
    """The names that these statements bind at module level, in blocks such as `if` and `try` too."""
    names: set[str] = set()
    for node in body:
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                names.add(name)
            case ast.Import(names=aliases) | ast.ImportFrom(names=aliases):
                names |= {alias.asname or alias.name.partition('.')[0] for alias in aliases}
            case ast.Assign() | ast.AnnAssign() | ast.AugAssign():
                targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                names |= {part.id for target in targets for part in ast.walk(target) if isinstance(part, ast.Name)}
            case ast.If() | ast.For() | ast.While() | ast.With() | ast.Try():
                for part in ('body', 'orelse', 'finalbody'):
                    names |= defined(getattr(node, part, []))
                for handler in getattr(node, 'handlers', []):
                    names |= defined(handler.body)
    return names
