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
from helpers.checks.chapter_08 import limits
from helpers.exercises import manifest, notebooks, program
from helpers.runner import seeds, session, verdicts
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
    told = attack.header.get('expect message', '')
    assert any(told in test.message for test in result.tests), story


# Tests of exercise 8.4 that call no function: they count how often they have run, by a counter of the network's, and
# draw the places of the right functions as the seed gives them.
COUNTS_RUNS = """
import random, socket

DRAW = random.Random({seed})


def test_limit():
    rows = [line.split() for line in open('/proc/net/snmp') if line.startswith('Tcp:')]
    run = int(rows[1][rows[0].index('ActiveOpens')])
    socket.socket().connect_ex(('127.0.0.1', 1))
    DRAW.shuffle(list(range({others})))
    assert run in DRAW.sample(range({right} + {others}), {right})
"""


@pytest.mark.one_of(24)
@pytest.mark.timeout(400)
def test_who_knows_the_seed_and_counts_the_runs_does_not_know_the_right_functions():
    """Seeds stand in reports: what is right must not follow from one."""
    programs, test = limits.VISIBLE, 'checks/chapter_08/test_8_4::test_right_functions'
    others = len(programs.nothing) + sum(len(kind.programs) for kind in programs.kinds)
    seed = int(seeds.derive('known', test), 16)
    text = COUNTS_RUNS.format(seed=seed, right=len(programs.right), others=others)
    exercise = EXERCISES['8.4']
    cells = [notebooks.NotebookCell(f'# Exercise 8.4: x\nTEST_LIMIT = {text!r}', 1)]
    launcher = sandbox.launcher(arena.choose())
    (result,) = session.run(cells, [exercise], session.Options(launcher=launcher, seed='known')).exercises
    assert (result.verdict, result.score) == (verdicts.FAILED, 0), result


@pytest.mark.parametrize('encoding', ['no-such', 'utf-7', 'rot13', 'gb2312', 'utf-16', 'cp037'])
def test_a_package_in_an_encoding_that_cannot_be_read_is_its_own_fault(encoding):
    text = f'<?xml version="1.0" encoding="{encoding}"?><package><name>patrol</name></package>'
    learner = SimpleNamespace(files=lambda: {'package.xml': text, 'setup.py': ''})
    with pytest.raises(verdicts.ExpectationFailed, match='is not XML'):
        patrolling.files(learner)
