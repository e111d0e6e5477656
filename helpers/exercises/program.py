"""From cells to the program that is run for one exercise.

The exercise's cell is taken whole, but for waits below the answer. From the cells before it come only definitions,
and from those after it the definitions that the program needs: statements that only demonstrate something never run.
The exercise's own cell must define the names that the exercise asks for. Nothing is executed here.
"""

import ast
import builtins
import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from helpers.exercises import cell_python, definitions, file_answers, syntax_words, trials
from helpers.exercises.manifest import Exercise, stub_digest
from helpers.exercises.notebooks import NotebookCell

HEADING = re.compile(r'#\s*Exercise\s+([0-9]{1,4}\.[0-9]{1,4})\b', re.IGNORECASE)
_BUILTINS = frozenset(dir(builtins))


class InvalidExercise(Exception):
    """One exercise's cell is missing, doubled or unreadable; the message is for the learner."""


class NotAttempted(Exception):
    """The exercise's cell is still what the learner was given."""


@dataclass
class Program:
    """What the learner's process loads for one exercise."""

    exercise: Exercise
    cells: list[dict]  # label, source, line (of its beginning in the cell), required
    answer: str  # the text of the exercise's cell, for tests that read it
    absent: dict[str, str] = field(default_factory=dict)  # why names are not there that cells bind: for messages
    # For the learner: what was done with the cell; no mark depends on it.
    notes: list[str] = field(default_factory=list)

    @property
    def title(self) -> str:
        """How messages name it."""
        return f'Exercise {self.exercise.id}'

    def as_dict(self) -> dict:
        """The program as a JSON value."""
        return {
            'title': self.title,
            'cells': self.cells,
            'answer': self.answer,
            'absent': self.absent,
            'notes': self.notes,
        }


def unsolved(exercise: str) -> str:
    """What is said of a cell that is still as it was given."""
    return f'Exercise {exercise} is not solved yet.'


def exercise_id(cell: NotebookCell) -> str | None:
    """The id in the cell's first line, `# Exercise 3.2: …`, or None."""
    first = next((line for line in cell_python.below_magics(cell.source).splitlines() if line.strip()), '')
    match = HEADING.match(first.strip())
    return match[1] if match else None


def of_exercise(cells: list[NotebookCell], exercise: Exercise) -> list[NotebookCell]:
    """The cells that claim to be this exercise's, by heading or by id."""
    return [
        cell
        for cell in cells
        if exercise_id(cell) == exercise.id or (cell.id == exercise.cell_id and exercise_id(cell) is None)
    ]


def defines_all(cell: NotebookCell, exercise: Exercise) -> bool:
    """Whether a cell binds all names that an exercise asks for."""
    return definitions.names_in(cell_python.as_python(cell)).issuperset(exercise.names)


def is_answer(cell: NotebookCell, exercise: Exercise) -> bool:
    """Whether there is more in a cell than comments, and other things than what was given."""
    text = cell_python.below_magics(cell.source)
    tree = cell_python.syntax_tree(text)
    return tree is None or bool(tree.body) and not exercise.is_stub(stub_digest(text))


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
    if missing := [name for name in exercise.names if name not in definitions.defined(tree.body)]:
        own += _continued(cells, cell, missing)
        missing = [name for name in missing if name not in definitions.names_in(own)]
    if missing:
        there = sorted(name for name in definitions.defined(tree.body) if not name.startswith('_'))
        raise InvalidExercise(
            f'The cell of exercise {exercise.id} must define `{missing[0]}`'
            + (f'; it defines {", ".join(f"`{name}`" for name in there[:5])}.' if there else '.')
            + _on_lost_line(cell, exercise)
        )
    place = cells.index(cell)
    above = [part for other in cells[:place] for part in _parts(other)]
    below = [part for other in cells[place + 1 :] for part in _parts(other)]
    mine = trials.parts(own, exercise.names, [part['source'] for part in (*above, *below)])
    program = Program(exercise, [*above, *_needed(below, [*above, {'source': own}])], own)
    program.cells += [
        {'label': cell.label, 'source': part.text, 'line': part.line, 'required': part.required}
        for part in mine
        if not part.left_out
    ]
    program.notes = [_on_left_out(exercise, *command) for command in commands[:3]]
    program.notes += [_on_trial(exercise, part) for part in mine if part.left_out][:3]
    used = definitions.names_used(own)
    program.notes += [
        _on_changed(other, name)
        for other in cells
        if other is not cell
        for name in sorted(definitions.changed_later(other) & used)
    ][:3]
    program.absent = _absent(program.cells, cells, notebook)
    return program


def _parts(cell: NotebookCell) -> list[dict]:
    """The definitions of a cell, as parts of a program."""
    return [
        {'label': cell.label, 'source': text, 'line': line, 'required': False}
        for line, text in definitions.of_cell(cell)
    ]


def _needed(below: list[dict], there: list[dict]) -> list[dict]:
    """Of the definitions below an exercise's cell those that its program needs: cells can be run in any order.

    :param there: the parts of the program without them, the exercise's own one last.
    """
    if not below:
        return []
    mine = there[-1]['source']
    above, last = _by_name(there[:-1]), _by_name(below)
    own = {*definitions.names_in(mine), *_BUILTINS}

    def parts_of(name: str) -> list[dict]:
        if name in own:
            return []
        return [there[place] for place in above.get(name, ())] or [below[place] for place in last.get(name, ())]

    needed = definitions.reached(
        definitions.names_used(mine),
        lambda name: [used for part in parts_of(name) for used in definitions.names_used(part['source'])],
    )
    chosen = {place for name in needed - own - above.keys() for place in last.get(name, ())}
    return [below[place] for place in sorted(chosen)]


def _by_name(parts: list[dict]) -> dict[str, list[int]]:
    """The places of the parts that make each name."""
    places: dict[str, list[int]] = {}
    for place, part in enumerate(parts):
        for name in definitions.names_made(part['source']):
            places.setdefault(name, []).append(place)
    return places


def _absent(parts: list[dict], cells: list[NotebookCell], notebook: Iterable[NotebookCell]) -> dict[str, str]:
    """Why names are not in a program that other cells bind, which a learner takes for there."""
    have = {name for part in parts for name in definitions.names_in(part['source'])}
    used = {name for part in parts for name in definitions.names_used(part['source'])} - have - _BUILTINS
    absent = {}
    for other in cells:
        for name in definitions.names_in(cell_python.as_python(other)) & used:
            absent[name] = (
                f'`{name}` is made in {other.label}, by a statement that does not run here: from other cells the check '
                f'takes imports, functions, classes and constants. Make `{name}` in the cell of the exercise.'
            )
    for other in notebook:
        for name in {name for _, text in definitions.of_cell(other) for name in definitions.names_in(text)} - have:
            absent.setdefault(name, f'`{name}` is defined in {other.label}: run that cell first, then check again.')
    return absent


def _only_cell(cells: list[NotebookCell], exercise: Exercise) -> NotebookCell:
    """The cell that holds the answer: of several that claim to be it, the one that is not a copy without an answer."""
    heading = f'# Exercise {exercise.id}: {exercise.title}'
    found = of_exercise(cells, exercise) or _with_heading_inside(cells, exercise)
    if not found:
        raise InvalidExercise(f'The cell of exercise {exercise.id} was not found: its first line must be `{heading}`.')
    answers = list({_as_program(cell): cell for cell in found if is_answer(cell, exercise)}.values())
    answers = [cell for cell in answers if defines_all(cell, exercise)] or answers  # not those that only try the answer
    if len(found) > 1 and len(answers) != 1:
        several = answers or found
        numbers = ' and '.join(str(cell.number) for cell in several if cell.number)
        raise InvalidExercise(
            f'Exercise {exercise.id} is there {len(several)} times'
            + (f' (cells {numbers})' if numbers else '')
            + f': keep one cell that begins with `{heading}`.'
        )
    return found[0] if len(found) == 1 else answers[0]


def _as_program(cell: NotebookCell) -> str:
    """What two cells have in common that differ in comments and layout only."""
    text = cell_python.below_magics(cell.source)
    return cell.source.strip() if cell_python.syntax_tree(text) is None else stub_digest(text)


def _with_heading_inside(cells: list[NotebookCell], exercise: Exercise) -> list[NotebookCell]:
    """The cells that have the exercise's heading further down, and define its names: others were merged with it."""
    return [
        cell
        for cell in cells
        if any((match := HEADING.match(line)) and match[1] == exercise.id for line in cell.source.split('\n'))
        and set(exercise.names) <= definitions.names_in(cell.source)
    ]


def _continued(cells: list[NotebookCell], cell: NotebookCell, missing: list[str]) -> str:
    """The text of the cells directly below an exercise's one, as far as they have what is missing: it was split.

    Nothing, if another exercise or a check comes before.
    """
    text = ''
    for other in cells[cells.index(cell) + 1 :]:
        more = cell_python.below_magics(file_answers.as_python(other.source))
        if (
            exercise_id(other) is not None
            or cell_python.syntax_tree(more) is None
            or re.search(r'^check\(', more, re.MULTILINE)
        ):
            return ''
        text += f'\n\n{more}'
        missing = [name for name in missing if name not in definitions.names_in(more)]
        if not missing:
            return text
    return ''


def _on_left_out(exercise: Exercise, number: int, line: str) -> str:
    return (
        f'Exercise {exercise.id}, line {number}: the notebook command `{line[:60]}` was left out, because only Python '
        'is tested. It is better off in a cell of its own.'
    )


def _on_trial(exercise: Exercise, part: trials.Part) -> str:
    line = part.text.strip().split('\n')[0]
    return (
        f'Exercise {exercise.id}, line {part.line}: `{line[:60]}` was left out: while a check loads the cell, nothing '
        'spins and no program is started. It is better off in a cell of its own.'
    )


def _on_changed(cell: NotebookCell, name: str) -> str:
    return (
        f'`{name}` is changed in {cell.label} by a statement that does not run here: the check has it as it was '
        f'before. Make `{name}` in the cell of the exercise.'
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


def _parse_exercise(cell: NotebookCell, exercise: Exercise, commands: list[tuple[int, str]]) -> tuple[str, ast.Module]:
    """The Python program that an exercise's cell is, and its syntax tree.

    :param commands: is given the lines that were left out, with their numbers.
    """
    source = cell_python.without_commands(cell_python.below_magics(file_answers.as_python(cell.source)), commands)
    try:
        tree = ast.parse(source)
        if cell_python.nesting(tree) > cell_python.MAX_NESTING:
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
            f'Exercise {exercise.id}, line {error.lineno}: Python cannot read `{text}` ({syntax_words.said(error)}).'
            + _on_lost_line(cell, exercise)
        ) from None
    except (ValueError, RecursionError, MemoryError):  # null bytes, very deep nesting
        raise InvalidExercise(f'Exercise {exercise.id}: Python cannot read the cell.') from None
