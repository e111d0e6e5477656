"""What a check adds for the learner that is no judgement: how somebody came to an answer. No mark depends on it."""

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
