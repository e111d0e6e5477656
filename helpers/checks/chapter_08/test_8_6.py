"""Visible tests of exercise 8.6, tests for the steering."""

import pytest

from helpers.checks.chapter_08.planted import NOTHING, STEERING, accepts, rejects
from helpers.checks.chapter_08.steerings import variant

pytestmark = pytest.mark.exercise('8.6')
RIGHT = {"the course's": variant()}


def test_right_function(learner):
    """Your tests pass with a function that does what exercise 8.5 says.

    Look at the specification again: what does it say, and what do you ask for?
    """
    accepts(learner, RIGHT, STEERING, wrong={'that returns nothing': variant(result=NOTHING)})


def test_simple_bugs(learner):
    """A function that turns the long way round fails, and one that mixes up left and right.

    Let the goal lie to the left, to the right, and behind.
    """
    rejects(learner, {
        'that turns the long way round': variant(angle='    angle = atan2(dy, dx) - yaw\n'),
        'that mixes up left and right': variant(result='    return distance, linear, -angular\n')},
            STEERING, right=RIGHT)
