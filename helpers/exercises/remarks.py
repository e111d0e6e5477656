"""What a check adds for the learner that is no judgement: how somebody came to an answer, and what it has lost.

No mark depends on it.
"""

import ast
from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the command line imports this module at its start
    from helpers.exercises.notebooks import NotebookCell
    from helpers.runner.results import ExerciseResult

LIVE = '7.8'  # the exercise whose systems note looks and changes


def after(exercises: 'Iterable[ExerciseResult]', cells: 'Iterable[NotebookCell]') -> list[str]:
    """The lines that stand below the results of a check of these cells."""
    result = next((one for one in exercises if one.id == LIVE and one.tests), None)
    if result is None:
        return []
    from helpers.exercises import program
    from helpers.programs.faults.live import name_in, way

    source = next((cell.source for cell in cells if program.exercise_id(cell) == LIVE), '')
    who = name_in(source)
    return [] if who is None else way(who, result.passed)


def lost(cells: 'list[NotebookCell]', saved: 'list[NotebookCell]') -> list[str]:
    """What the last of these cells, an answer, needs of cells that are no longer in the notebook as it was last saved.

    Nothing is said before the answer itself is saved.
    """
    from helpers.exercises import cell_python, definitions

    *others, answer = cells
    texts, ids = {cell.source.strip() for cell in saved}, {cell.id for cell in saved}
    if answer.source.strip() not in texts:
        return []
    there = {name for cell in saved for name in definitions.names_in(cell_python.as_python(cell))}
    missing = definitions.names_used(cell_python.as_python(answer)) - there
    gone = [cell for cell in others if cell.source.strip() not in texts and cell.id not in ids]
    made = {name for cell in gone for _, text in definitions.of_cell(cell) for name in definitions.names_in(text)}
    return [
        f'`{name}` comes from a cell that is no longer in the saved notebook, and will be missing when you hand in: '
        f'write `{name}` into the cell of the exercise.'
        for name in sorted(made & missing)
    ]


def changed(cells: 'list[NotebookCell]', saved: 'list[NotebookCell]', edited: Collection[str]) -> list[str]:
    """What the last of these cells, an answer, needs and gets otherwise from the notebook as it was last saved.

    Nothing is said of what may only not be saved yet.

    :param edited: ids of cells whose text was changed, and saved, after they were last run
    """
    *others, answer = cells
    place = next((number for number, cell in enumerate(saved) if cell.source.strip() == answer.source.strip()), None)
    if place is None:
        return []
    ran, there = _needed(answer, others), _needed(answer, saved[:place], saved[place + 1 :])
    texts = {cell.source.strip() for cell in saved}
    said = []
    for name in sorted(ran.keys() & there.keys()):
        (mine, text), (theirs, other) = ran[name], there[name]
        if _meaning(name, text) == _meaning(name, other):
            continue
        if mine.id is not None and mine.id == theirs.id:
            if mine.id in edited:
                said.append(
                    f'The cell that defines `{name}` was changed and saved after you ran it. Run it, and check again.'
                )
        elif mine.source.strip() in texts:
            said.append(
                f'Two cells define `{name}`, which your answer needs. You ran {mine.label} last, and when you hand in, '
                f'{theirs.label} counts. Write `{name}` into the cell of the exercise.'
            )
    return said


def _meaning(name: str, text: str) -> str:
    """The text that defines a name; of an import only what belongs to it."""
    from helpers.exercises import cell_python

    tree = cell_python.syntax_tree(text)
    for node in tree.body if tree else []:
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            for alias in node.names:
                if name in (alias.asname, alias.name):
                    return f'{getattr(node, "module", "")}: {alias.name}'
    return text.strip()


def _needed(
    answer: 'NotebookCell', above: 'Iterable[NotebookCell]', below: 'Iterable[NotebookCell]' = ()
) -> 'dict[str, tuple[NotebookCell, str]]':
    """The names that an answer needs from other cells, each with the cell and the text that define it.

    As in its program: of several cells above it the last one counts, and one below it only if none is above.
    """
    from helpers.exercises import cell_python, definitions

    made: dict[str, tuple[NotebookCell, str]] = {}
    for group in (below, above):
        for cell in group:
            for _, text in definitions.of_cell(cell):
                made |= dict.fromkeys(definitions.names_in(text), (cell, text))
    used = definitions.names_used(cell_python.as_python(answer))
    needed = definitions.reached(used, lambda name: definitions.names_used(made[name][1]) if name in made else ())
    return {name: made[name] for name in needed if name in made}
