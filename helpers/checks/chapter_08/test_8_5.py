"""Visible tests of exercise 8.5, steering."""

import pytest

from helpers.checks.chapter_08 import steerings
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.5')


@pytest.mark.rules('distance', 'angle', 'short-way', 'max-angular')
def test_turns(learner):
    """Distance and turn are right for a robot anywhere that looks anywhere.

    dx and dy are differences, and the angle is the direction of the goal less the yaw of the robot.
    """
    found = steerings.steer(learner, 'distance', 0, 0, 0, 3, 0, 0.5, 1)
    expect(
        found[0] == pytest.approx(3.0),
        f'steer(0, 0, 0, 3, 0, 0.5, 1): the distance is {found[0]:g} m, expected 3 m.',
        'distance',
    )
    steerings.judge_distance(learner)
    steerings.judge_angle(learner)


@pytest.mark.rules('distance', 'angle', 'max-angular', 'linear', 'on-the-spot', 'at-the-goal')
def test_drives(learner):
    """The robot drives with the distance, at most max_linear; turns on the spot beyond 0.5 rad; stands at the goal.

    abs(angle) is the size of the angle.
    """
    steerings.judge_speed(learner)
    steerings.judge_goal(learner)
    steerings.judge_borders(learner)
    steerings.judge_anywhere(learner)
