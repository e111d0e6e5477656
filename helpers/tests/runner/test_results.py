"""Scores fail closed: only an explicit pass counts, and a grader's fault is never a zero."""

import itertools
from dataclasses import replace

import pytest

from helpers.runner import results, verdicts
from helpers.runner.results import TestResult
from helpers.tests import small


def one(name, verdict, weight=1.0, exercise='90.1'):
    return TestResult(name, exercise, False, weight, verdict)


@pytest.mark.parametrize(
    ('kinds', 'verdict', 'score'),
    [
        (['passed', 'passed'], 'passed', 10),
        (['passed', 'failed'], 'failed', 5),
        (['timeout', 'failed', 'passed'], 'timeout', 3.33),
        (['learner_crashed', 'failed'], 'learner_crashed', 0),
        (['passed', 'grader_error'], 'grader_error', None),
        ([], 'grader_error', None),
        (['passed', 'splendid'], 'grader_error', None),
    ],
)
def test_scored(kinds, verdict, score):
    judged = results.scored(small.exercise(), [one(str(number), kind) for number, kind in enumerate(kinds)])
    assert (judged.verdict, judged.score) == (verdict, score)


def test_weights():
    judged = results.scored(small.exercise(), [one('a', 'passed', 3), one('b', 'failed', 1)])
    assert judged.score == 7.5


@pytest.mark.parametrize('weight', [0, -1, float('nan'), float('inf')])
def test_unusable_weights(weight):
    judged = results.scored(small.exercise(), [one('a', 'passed', weight), one('b', 'passed')])
    assert judged.score is None


def test_doubled_and_foreign_tests():
    assert results.scored(small.exercise(), [one('a', 'passed'), one('a', 'passed')]).score is None
    assert results.scored(small.exercise(), [one('a', 'passed', exercise='90.2')]).score is None


@pytest.mark.parametrize(
    ('passes', 'score'), [('', 0), ('a', 0), ('ab', 0), ('c', 2.5), ('ac', 5), ('abc', 7.5), ('abcd', 10)]
)
def test_what_was_right_as_it_was_given(passes, score):
    """Two tests that the cell passes as it was given count as soon as another one passes."""
    tests = [replace(one(name, 'passed' if name in passes else 'failed'), given=name in 'ab') for name in 'abcd']
    judged = results.scored(small.exercise(), tests)
    assert (judged.score, judged.message) == (score, results.AS_GIVEN if passes and not score else '')


def test_no_more_than_the_passes():
    for kinds in itertools.product(verdicts.VERDICTS, repeat=3):
        judged = results.scored(small.exercise(), [one(str(number), kind) for number, kind in enumerate(kinds)])
        explicit = 10 * kinds.count('passed') / 3
        assert judged.score is None or judged.score <= explicit + 0.01
        assert judged.passed == (kinds == ('passed',) * 3)


def test_round_trip():
    judged = results.scored(small.exercise(), [one('a', 'passed'), one('b', 'failed')])
    assert results.ExerciseResult.from_dict(judged.as_dict()) == judged
