"""Attacks on what counts as evidence: the real exercises that judge commands, packages, launched systems and tests.

Each row of `evidence/` is an exercise's cell. It gains nothing: the rules that it keeps honestly stand in its header
(`may keep`), by their names, as points change with the tests of an exercise. The right answers to the same exercises
get full marks: see `grading/tests/test_validity.py`.
"""

from types import SimpleNamespace

import pytest

from grading import reference, sandbox
from grading.course import HIDDEN
from grading.tests.attacks import arena
from helpers.checks.chapter_02 import patrolling
from helpers.exercises import manifest, notebooks, program
from helpers.runner import session, verdicts
from helpers.runner.results import KEPT

ATTACKS = [attack for path in sorted((arena.HERE / 'evidence').glob('*.py')) for attack in arena.read(path)]
EXERCISES = manifest.load()


@pytest.mark.one_of(24)
@pytest.mark.timeout(400)
@pytest.mark.parametrize('attack', ATTACKS, ids=lambda attack: attack.name)
def test_no_evidence_can_be_made(attack):
    exercise = EXERCISES[attack.aim]
    cells = [
        notebooks.NotebookCell(f'# Exercise {exercise.id}: x\n{attack.source}', cell.number, cell.id)
        if program.exercise_id(cell) == exercise.id
        else cell
        for cell in reference.solved(exercise.chapter)
    ]
    report = session.run(
        cells,
        [exercise],
        session.Options(
            hidden=HIDDEN, launcher=sandbox.launcher(arena.choose()), seed='evidence', reference=reference.program
        ),
    )
    (result,) = report.exercises
    story = [(test.test, test.verdict, test.message[:300], test.fault[-600:]) for test in result.tests], report.log
    assert result.verdict not in (verdicts.PASSED, verdicts.GRADER_ERROR), story
    honest = {name for name in attack.header.get('may keep', '').split(', ') if name}
    assert honest <= {rule.name for rule in result.rules}, 'a rule that the card does not have'
    assert {rule.name for rule in result.rules if rule.state == KEPT} <= honest, story
    assert all(honest & set(test.rules) for test in result.tests if test.passed), story  # no point for anything else
    assert honest or result.score == 0, story


@pytest.mark.parametrize('encoding', ['no-such', 'utf-7', 'rot13', 'gb2312', 'utf-16', 'cp037'])
def test_a_package_in_an_encoding_that_cannot_be_read_is_its_own_fault(encoding):
    text = f'<?xml version="1.0" encoding="{encoding}"?><package><name>patrol</name></package>'
    learner = SimpleNamespace(files=lambda: {'package.xml': text, 'setup.py': ''})
    with pytest.raises(verdicts.ExpectationFailed, match='is not XML'):
        patrolling.files(learner)
