"""What a check adds for the learner that is no judgement: how somebody came to an answer, and what it has lost.

No mark depends on it.
"""

from collections.abc import Iterable
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
