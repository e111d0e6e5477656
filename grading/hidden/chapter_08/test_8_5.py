"""Hidden tests of exercise 8.5, steering."""

import math

import pytest

from helpers.checks.chapter_08.steerings import right, words
from helpers.checks.chapter_08.test_8_5 import steer
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.5')


def case(learner, angle, distance, yaw=None, max_linear=None, max_angular=None):
    """Arguments: the robot anywhere, the goal at this angle (rad) to where it looks, so far away (m)."""
    draw = learner.random
    x, y = draw.uniform(0.5, 3), -draw.uniform(0.5, 3)
    yaw = draw.uniform(-3, 3) if yaw is None else yaw
    goal = x + distance * math.cos(yaw + angle), y + distance * math.sin(yaw + angle)
    return x, y, yaw, *goal, max_linear or draw.uniform(0.3, 0.9), max_angular or draw.uniform(0.5, 1.5)


def judge(learner, *arguments):
    """Compare what the learner's function returns with what is right."""
    got, wanted = steer(learner, *arguments), right(*arguments)
    for name, one, other, unit in zip(('distance', 'linear', 'angular'), got, wanted, ('m', 'm/s', 'rad/s'),
                                      strict=True):
        expect(one == pytest.approx(other, abs=1e-6), f'{words(arguments)}: {name} is {one:.3f} {unit}, expected '
                                                      f'{other:.3f}.')


@pytest.mark.weight(3)
def test_values(learner):
    """distance, linear and angular are right for a robot anywhere that looks anywhere.

    dx and dy are differences, and the angle is the direction of the goal less the yaw of the robot.
    """
    draw = learner.random
    for angle in (0.0, draw.uniform(0.1, 0.2), -draw.uniform(0.1, 0.2), draw.uniform(1, 2), -draw.uniform(1, 2)):
        for distance in (draw.uniform(0.05, 0.25), draw.uniform(1.5, 4)):
            judge(learner, *case(learner, angle, distance))


@pytest.mark.weight(2)
def test_short_way(learner):
    """The robot turns the short way round, wherever it looks.

    math.remainder(angle, math.tau) brings an angle into the range from -π to π.
    """
    draw = learner.random
    for side in (1, -1):
        for yaw in (draw.uniform(2.7, 3.1), 3 * math.pi):
            arguments = case(learner, side * draw.uniform(1, 2.5), 2.0, yaw=side * yaw)
            angular = steer(learner, *arguments)[2]
            expect(angular * side > 0, f'{words(arguments)}: angular is {angular:.2f} rad/s. The robot turns the long '
                                       'way round.')


@pytest.mark.weight(2)
def test_turns_on_the_spot(learner):
    """linear is 0 if the angle is more than 0.5 rad, to either side; up to 0.5 rad it is not.

    abs(angle).
    """
    draw = learner.random
    for side in (1, -1):
        arguments = case(learner, side * draw.uniform(0.55, 0.9), draw.uniform(0.5, 2))
        linear = steer(learner, *arguments)[1]
        expect(linear == 0, f'{words(arguments)}: linear is {linear:.2f} m/s, and the robot looks more than 0.5 rad '
                            f'to the {"right" if side > 0 else "left"} of its goal. First it must turn.')
        judge(learner, *case(learner, side * draw.uniform(0.3, 0.45), draw.uniform(0.5, 2)))


@pytest.mark.weight(2)
def test_limits(learner):
    """angular is never more than max_angular, to either side, and linear never more than max_linear.

    max(-max_angular, min(max_angular, …)).
    """
    draw = learner.random
    linear, angular = draw.uniform(0.1, 0.3), draw.uniform(0.2, 0.4)
    for angle in (0.4, -0.4, 2.0, -2.0):
        arguments = case(learner, angle, draw.uniform(1, 3), max_linear=linear, max_angular=angular)
        got = steer(learner, *arguments)
        expect(abs(got[2]) <= angular + 1e-6, f'{words(arguments)}: angular is {got[2]:.2f} rad/s, and max_angular is '
                                              f'{angular:.2f}.')
        expect(abs(got[1]) <= linear + 1e-6, f'{words(arguments)}: linear is {got[1]:.2f} m/s, and max_linear is '
                                             f'{linear:.2f}.')


def test_at_the_goal(learner):
    """At the goal itself all three are 0.

    math.atan2(0, 0) is 0: that looks like a direction, and is none.
    """
    draw = learner.random
    x, y, yaw = draw.uniform(1, 3), draw.uniform(1, 3), draw.choice([-1, 1]) * draw.uniform(0.5, 3)
    got = steer(learner, x, y, yaw, x, y, 0.5, 1.0)
    expect(got == (0, 0, 0), f'The robot is at its goal and looks to {yaw:.2f} rad: steer returned {got}, expected '
                             'three zeros.')
