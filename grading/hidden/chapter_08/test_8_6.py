"""Hidden tests of exercise 8.6, tests for the steering: other right functions, and wrong ones in three groups."""

import pytest

from helpers.checks.chapter_08.planted import NOTHING, STEERING, accepts, rejects
from helpers.checks.chapter_08.steerings import variant

pytestmark = pytest.mark.exercise('8.6')
RIGHT = {"the course's": variant()}
NOTHINGS = {'that returns nothing': variant(result=NOTHING)}


@pytest.mark.weight(3)
def test_right_functions(learner):
    """Your tests pass with every function that does what exercise 8.5 says, however it computes.

    Compare with pytest.approx, also with abs=…: a zero may come out as 1e-17.
    """
    accepts(learner, {
        'one that computes its angle in another way': variant(
            angle='    from math import cos, sin\n    angle = atan2(dy, dx) - yaw\n'
                  '    angle = atan2(sin(angle), cos(angle))\n'),
        'one whose turn is limited first': variant(
            angular='    half = max_angular / 2\n    angular = 2 * max(-half, min(half, angle))\n'),
        'one that asks for the distance with **': variant(
            way='    dx, dy = goal_x - x, goal_y - y\n    distance = (dx ** 2 + dy ** 2) ** 0.5\n')},
            STEERING, wrong=NOTHINGS)


@pytest.mark.weight(3)
def test_turns(learner):
    """Your tests notice a wrong angle, a wrong factor, and a missing limit to one side.

    Left and right, small and large angles, and a robot that looks somewhere.
    """
    rejects(learner, {
        'that forgets where the robot looks': variant(angle='    angle = remainder(atan2(dy, dx), tau)\n'),
        'that has dx and dy the wrong way round': variant(angle='    angle = remainder(atan2(dx, dy) - yaw, tau)\n'),
        'that turns with 1 times the angle': variant(
            angular='    angular = max(-max_angular, min(max_angular, angle))\n'),
        'that has no limit to the right': variant(angular='    angular = min(max_angular, 2 * angle)\n'),
        'that has no limit to the left': variant(angular='    angular = max(-max_angular, 2 * angle)\n'),
        'that always turns as fast as it may': variant(
            angular='    angular = max_angular if angle > 0 else -max_angular if angle < 0 else 0.0\n'),
        'for which max_angular is fixed': variant(angular='    angular = max(-1.0, min(1.0, 2 * angle))\n')},
            STEERING, right=RIGHT)


@pytest.mark.weight(3)
def test_drives(learner):
    """Your tests notice a wrong speed: while it looks away, near the goal, and at the limit.

    Let the goal lie near and far, ahead, to the left, to the right and behind.
    """
    rejects(learner, {
        'that drives while it looks away': variant(linear='    linear = min(max_linear, distance)\n'),
        'that drives when the goal is on its right': variant(
            linear='    linear = min(max_linear, distance) if angle <= 0.5 else 0.0\n'),
        'that does not drive if it does not look exactly at the goal': variant(
            linear='    linear = min(max_linear, distance) if abs(angle) < 0.02 else 0.0\n'),
        'that does not slow down': variant(linear='    linear = max_linear if abs(angle) <= 0.5 else 0.0\n'),
        'that has no limit of its speed': variant(linear='    linear = distance if abs(angle) <= 0.5 else 0.0\n'),
        'for which max_linear is fixed': variant(
            linear='    linear = min(0.5, distance) if abs(angle) <= 0.5 else 0.0\n')}, STEERING, right=RIGHT)


@pytest.mark.weight(2)
def test_places(learner):
    """Your tests notice a wrong distance, a robot that is taken to be in the origin, and one that turns at its goal.

    Let the robot stand somewhere; also at its goal.
    """
    rejects(learner, {
        'that forgets where the robot is': variant(way='    dx, dy = goal_x, goal_y\n    distance = hypot(dx, dy)\n'),
        'whose distance is the one along x': variant(
            way='    dx, dy = goal_x - x, goal_y - y\n    distance = abs(dx)\n'),
        'whose distance goes round the corner': variant(
            way='    dx, dy = goal_x - x, goal_y - y\n    distance = abs(dx) + abs(dy)\n'),
        'that turns at the goal': variant(goal='')}, STEERING, right=RIGHT)
