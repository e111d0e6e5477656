"""What the learner is told of a test of theirs that fails with a right program (exercises 8.4, 8.6 and 8.11)."""

import pytest

from helpers.checks.chapter_08 import planted
from helpers.checks.chapter_08.noticed import Kind, Planted
from helpers.checks.chapter_08.planted import TestsOutcome
from helpers.runner import verdicts

NAMED = 'FAILED test/test_limit.py::test_limit[0.6] - {}\n'
PLACED = '/home/ws/test/test_limit.py:21: {}\n'


@pytest.mark.parametrize(
    ('output', 'reason'),
    [
        (
            PLACED.format('assert 0.24999999999999997 == 0.25') + NAMED.format('assert 0.2499999999...'),
            'your test test_limit[0.6], line 21: assert 0.24999999999999997 == 0.25',
        ),
        (
            PLACED.format('Failed: DID NOT RAISE') + NAMED.format('Failed: DID NOT RAISE ValueError'),
            'your test test_limit[0.6], line 21: Failed: DID NOT RAISE ValueError',
        ),
        (
            '/home/ws/test/conftest.py:40: Failed: it took too long\n' + NAMED.format('Failed: it took...'),
            'your test test_limit[0.6]: Failed: it took...',
        ),
        (
            "E       fixture 'benhc' not found\nERROR test/test_limit.py::test_free\n",
            "your test test_free: fixture 'benhc' not found",
        ),
        ('Killed\n', ''),
    ],
)
def test_the_reason_says_what_was_compared_where_that_is_known(output, reason):
    assert TestsOutcome(1, output).reason == reason


@pytest.mark.parametrize(
    ('said', 'words'),
    [
        ("NameError: name 'pytest' is not defined", 'Write: import pytest'),
        ("NameError: name 'isclose' is not defined", 'Write: from math import isclose'),
        ("NameError: name 'bench' is not defined", 'then it is a parameter of the test function'),
        ("fixture 'benhc' not found", 'and nothing is called `benhc`'),
    ],
)
def test_a_missing_name_is_explained(said, words):
    assert words in TestsOutcome(1, PLACED.format(said) + NAMED.format(said)).missing_name


@pytest.mark.parametrize(
    ('output', 'told'),
    [
        (
            "In test/test_limit.py::test_limit: function uses no argument 'speed'\nERROR test/test_limit.py\n",
            "test_limit: function uses no argument 'speed'",
        ),
        (
            "test/test_limit.py:9: in <module>\nE   NameError: name 'pytest' is not defined\n",
            "NameError: name 'pytest' is not defined (test_limit.py:9). Nothing imports `pytest` here. "
            'Write: import pytest',
        ),
    ],
)
def test_why_pytest_could_not_begin(output, told):
    assert planted._unreadable(output) == told


class Learner:
    """What `judge` asks of the fixture `learner`."""

    def __init__(self):
        self.server = self
        self.workspaces = {}

    def text(self, name):
        return 'the tests'


RIGHT, WRONG = [f'right {n}' for n in range(4)], [f'wrong {n}' for n in range(12)]


def texts(*names):
    """Modules whose function is its own name."""
    return {name: f'limit = {name!r}' for name in names}


PLANTED = Planted(
    planted.LIMIT, 'right-functions', texts(*RIGHT), texts('nothing'), (Kind('slope', 'that are wrong', texts(*WRONG)),)
)


def test_right_programs_may_be_anywhere_and_keep_their_order():
    seen = set()
    for _ in range(200):
        order = planted._order(RIGHT, WRONG)
        assert sorted(order) == sorted(RIGHT + WRONG)
        assert [name for name in order if name in RIGHT] == RIGHT
        seen |= {order.index(name) for name in RIGHT}
    assert seen == set(range(len(RIGHT + WRONG))), 'a place in the order tells which programs are right'


@pytest.mark.parametrize('status', [1, planted.ENDED, 2, 5])
def test_after_a_right_program_with_which_the_tests_fail_no_other_one_is_run(monkeypatch, status):
    """The learner is told this cause, for each kind of wrong programs."""
    run = []

    class Task:
        output = ''

        def __init__(self, name):
            self.name = name

        def wait(self, seconds):
            return status if self.name == RIGHT[1] else 0 if self.name in RIGHT else 1

    class Place:
        def pytest(self, *argv, functions, without):
            return Task(run[-1])

        def forget(self):
            pass

    class Served:
        other = 0

        def __init__(self, function):
            run.append(function)

        def close(self):
            pass

    learner = Learner()
    learner.workspace = lambda files, alone: Place()
    monkeypatch.setattr(planted, 'Served', Served)
    monkeypatch.setattr(planted, '_order', lambda right, others: [RIGHT[0], WRONG[0], *RIGHT[1:], *WRONG[1:]])
    for judge in (PLANTED.accepts, lambda learner: PLANTED.rejects(learner, 'slope')):
        with pytest.raises(verdicts.ExpectationFailed):
            judge(learner)
    assert run == [RIGHT[0], WRONG[0], RIGHT[1]]
