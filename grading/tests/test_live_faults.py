"""Exercise 7.8 for other names than the solution's: whatever is drawn, the truth and the course's repair are right."""

import functools

import pytest

from grading import trial
from helpers.exercises import manifest, notebooks, program
from helpers.programs.faults.live import EXERCISE, NUMBERS, Planned, differences

pytestmark = [pytest.mark.timeout(300), pytest.mark.one_of(4)]


@functools.cache
def kinds(who: str) -> set[tuple]:
    """What the systems of a name have: fault, cause, and what is different."""
    systems = (Planned(who, number) for number in NUMBERS)
    return {(name, one.cause, tuple(one.change)) for system in systems for name, one in system.drawn.items()}


def names() -> list[str]:
    """Names whose systems have all kinds of faults together."""
    found, missing = [], set().union(*(kinds(f'learner {k}') for k in range(150)))
    while missing:
        found.append(max((f'learner {k}' for k in range(150)), key=lambda who: len(kinds(who) & missing)))
        missing -= kinds(found[-1])
    return found


def told(who: str) -> str:
    """The answer that says the truth, in its own words, and repairs as the course does."""
    systems = {number: Planned(who, number) for number in NUMBERS}
    findings = {number: [tuple(one) for one in system.diagnosis] for number, system in systems.items()}
    changes = {number: differences(system.files, system.files | system.repaired) for number, system in systems.items()}
    return f'NAME = {who!r}\nFINDINGS = {findings!r}\nCHANGES = {changes!r}\n'


@pytest.mark.parametrize('who', names())
def test_the_truth_of_a_name_gets_full_marks(who):
    cells = [
        notebooks.NotebookCell(f'# Exercise {EXERCISE}:\n{told(who)}', cell.number, cell.id)
        if program.exercise_id(cell) == EXERCISE
        else cell
        for cell in trial.solved(7)
    ]
    report = trial.judge(cells, [manifest.load()[EXERCISE]])
    assert trial.faults_of_right(report.exercises[0]) == [], report.log
