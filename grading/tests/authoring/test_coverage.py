"""The table of rules: what is in it, and what it finds missing."""

import pytest

from grading.authoring import coverage
from helpers.exercises.manifest import Rule
from helpers.tests import small

VISIBLE = """import pytest
pytestmark = [pytest.mark.exercise('90.1'), pytest.mark.not_looked_at(rule='stops', why='takes an hour')]


@pytest.mark.rules('rate', 'texts')
@pytest.mark.weight(2)
def test_rate(learner):
    pass
"""
HIDDEN = """import pytest
pytestmark = pytest.mark.rules('stops')


def test_stop(learner):
    pass
"""
MUTANTS = """from grading.variants import Mutant
MUTANTS = [Mutant('slow', old='1', new='2', breaks='rate', also=('texts',)),
           Mutant('runs', old='1', new='3', breaks='stops')]
"""
EXERCISE = small.exercise(rules=(Rule('rate', 'Four.'), Rule('texts', 'Words.'), Rule('stops', 'It stops.')))


def table(tmp_path, visible=VISIBLE, hidden=HIDDEN, mutants=MUTANTS, exercise=EXERCISE):
    for path, text in (
        ('checks/chapter_90/test_90_1.py', visible),
        ('exercises/90_1/hidden.py', hidden),
        ('exercises/90_1/mutants.py', mutants),
    ):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    return coverage.table([exercise], tmp_path / 'checks', tmp_path / 'exercises')


def test_a_complete_table(tmp_path):
    made = table(tmp_path)
    assert made.complete
    assert [line.split() for line in made.lines()] == [
        ['exercise', 'rule', 'visible', 'tests', 'mutants'],
        ['90.1', 'rate', 'test_rate', 'slow'],
        ['90.1', 'texts', 'test_rate', 'slow'],
        ['90.1', 'stops', '-', '(takes', 'an', 'hour)', 'test_stop', 'runs'],
    ]


@pytest.mark.parametrize(
    ('change', 'found'),
    [
        ({'visible': VISIBLE.replace("'rate', ", '')}, 'rate   NONE'),
        ({'hidden': 'x = 1'}, 'NO HIDDEN TEST'),
        ({'mutants': MUTANTS.replace("breaks='stops'", "breaks='rate'")}, 'NONE'),
        ({'mutants': MUTANTS.replace("breaks='stops'", "breaks='rats'")}, "mutant 'runs' names the rule 'rats'"),
        ({'mutants': MUTANTS.replace(", breaks='stops'", '')}, "'runs' does not say which rule it breaks"),
        ({'visible': VISIBLE.replace("'texts'", "'text'")}, "a visible test names the rule 'text'"),
        ({'hidden': HIDDEN.replace("'stops'", "'stop'")}, "a hidden test names the rule 'stop'"),
        ({'visible': VISIBLE.replace(", why='takes an hour'", '')}, 'test_90_1.py:2: write pytest.mark.rules'),
    ],
)
def test_what_is_missing_or_wrong(tmp_path, change, found):
    made = table(tmp_path, **change)
    assert not made.complete and found in '\n'.join(made.lines())


def test_an_exercise_without_rules_is_not_complete(tmp_path):
    made = table(tmp_path, 'x = 1', 'x = 1', 'MUTANTS = []', small.exercise())
    assert not made.complete and made.lines() == ['exercise 90.1: its card has no rules']
