"""Hidden tests of exercise 8.5, steering."""

import math

import pytest

from helpers.checks.chapter_08 import steerings
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.5')


@pytest.mark.rules('distance')
def test_distance(learner):
    """The distance is right for a robot anywhere."""
    steerings.judge_distance(learner)


@pytest.mark.rules('angle', 'short-way', 'max-angular')
@pytest.mark.weight(4)
def test_turns(learner):
    """The turn is right wherever the robot looks, the short way round, and never more than max_angular.

    math.remainder(angle, math.tau) brings an angle into the range from -π to π.
    """
    steerings.judge_angle(learner)


@pytest.mark.rules('distance', 'angle', 'max-angular', 'linear', 'on-the-spot')
@pytest.mark.weight(3)
def test_drives(learner):
    """The speed is the distance, at most max_linear, and 0 if the angle is more than 0.5 rad to either side.

    abs(angle).
    """
    steerings.judge_speed(learner)
    steerings.judge_borders(learner)
    steerings.judge_anywhere(learner)


@pytest.mark.given
@pytest.mark.rules('at-the-goal')
def test_at_the_goal(learner):
    """At the goal itself all three are 0.

    math.atan2(0, 0) is 0: that looks like a direction, and is none.
    """
    steerings.judge_goal(learner)


@pytest.mark.rules('angle', 'linear')
@pytest.mark.weight(2)
def test_arrives(learner):
    """A robot that is steered in steps of 0.1 s arrives at its goal, from everywhere."""
    draw = learner.random
    x, y, yaw, goal_x, goal_y, *_ = steerings.case(
        draw, draw.choice([-1, 1]) * draw.uniform(1, 3), 1.2, yaw=draw.uniform(-3, 3)
    )
    for _ in range(120):
        distance, linear, angular = steerings.steer(learner, 'angle', x, y, yaw, goal_x, goal_y, 0.8, 1.8)
        x, y, yaw = x + 0.1 * linear * math.cos(yaw), y + 0.1 * linear * math.sin(yaw), yaw + 0.1 * angular
    expect(
        math.dist((x, y), (goal_x, goal_y)) < 0.05,
        f'Steered for 12 s, the robot is still {math.dist((x, y), (goal_x, goal_y)):.2f} m away from its goal.',
        'linear',
    )
