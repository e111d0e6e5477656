"""Visible tests of exercise 8.5, steering."""

import math

import pytest

from helpers.checks.chapter_08.steerings import words
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.5')


def steer(learner, *arguments: float) -> tuple[float, float, float]:
    """What the learner's function returns: three finite numbers."""
    found = learner.call('steer', *map(float, arguments))
    expect(isinstance(found, (list, tuple)) and len(found) == 3
           and all(type(one) in (int, float) and math.isfinite(one) for one in found),
           f'{words(arguments)} returned {found!r}, expected three finite numbers: distance, linear, angular.')
    return tuple(found)


def test_ahead(learner):
    """A goal 3 m ahead: full speed, and no turn.

    linear is the distance, but never more than max_linear.
    """
    found = steer(learner, 0, 0, 0, 3, 0, 0.5, 1)
    expect(found == pytest.approx((3.0, 0.5, 0.0)), f'steer(0, 0, 0, 3, 0, 0.5, 1) returned {found}, expected '
                                                    '(3, 0.5, 0).')


def test_aside(learner):
    """A goal to the left: the robot turns on the spot, to the left.

    linear is 0 if the angle is more than 0.5 rad; angular is never more than max_angular.
    """
    found = steer(learner, 0, 0, 0, 0, 3, 0.5, 1)
    expect(found == pytest.approx((3.0, 0.0, 1.0)), f'steer(0, 0, 0, 0, 3, 0.5, 1) returned {found}, expected '
                                                    '(3, 0, 1).')
