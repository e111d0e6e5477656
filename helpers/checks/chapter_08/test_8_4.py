"""Visible tests of exercise 8.4, tests that find bugs."""

from pathlib import Path

import pytest

from helpers.checks.chapter_08.limits import variant
from helpers.checks.chapter_08.planted import NOTHING, accepts, rejects

pytestmark = pytest.mark.exercise('8.4')

GIVEN = Path(__file__).parent / 'given' / 'speed' / 'speed' / 'limit.py'
RIGHT = {'the given one': GIVEN.read_text()}


def test_right_function(learner):
    """Your tests pass with the function as it is given.

    Run them by hand and read what fails.
    """
    accepts(learner, RIGHT, wrong={'that returns nothing': variant(result=NOTHING)})


def test_simple_bugs(learner):
    """A function that does not limit at all, one that never drives backwards, and one that ignores obstacles fail.

    A test for each sentence of the docstring.
    """
    rejects(learner, {
        'that returns the speed as it is': variant(check='', back='', nan='', share='', result='    return speed\n'),
        'that never drives backwards': variant(back='    if speed <= 0:\n        return 0.0\n'),
        'that ignores obstacles': variant(nan='', share='    share = 1.0\n')}, right=RIGHT)
