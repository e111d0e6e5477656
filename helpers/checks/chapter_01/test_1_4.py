"""Visible tests of exercise 1.4, drive the turtle to a goal."""

import pytest

from helpers.checks.chapter_01 import goals

pytestmark = [pytest.mark.exercise('1.4'), pytest.mark.wiring(type='topics', qos='topics', namespace='topics')]


@pytest.mark.rules('node', 'topics', 'reach', 'stop')
def test_any_goal(learner):
    """From any place the turtle comes to its goal, stops and stays.

    math.atan2(dy, dx) is the direction to the goal; subtract the heading, and turn by the rest.
    """
    drive = goals.any_goal(learner, f'/sim{learner.random.randint(2, 9)}', straight=True)
    drive.check_ends()
    drive.begin_another()
    drive.to_the_goal()
    drive.stays(2.0)
    drive.other_one_drives()


@pytest.mark.rules('reach', 'stop')
def test_far_and_near(learner):
    """Across the whole world 20 s are enough, and a turtle that starts at its goal stands still at once.

    math.atan2(0, 0) is 0, and that is no direction to turn to.
    """
    drive = goals.across_the_world(learner)
    drive.to_the_goal()
    drive.node.stop()  # two drivers would steer one turtle
    goals.there_already(learner).stays(1.0)


@pytest.mark.parametrize('side', (1, -1), ids=('left', 'right'))
@pytest.mark.rules('short-way')
def test_short_way(learner, side):
    """The turtle turns the short way to both sides, also where the angle jumps from π to −π.

    math.remainder(error, 2 * math.pi) brings the error into −π … π.
    """
    goals.across_pi(learner, side)


@pytest.mark.rules('walls', 'short-way')
def test_goal_behind(learner):
    """A goal behind a turtle that looks at a near wall is reached without touching the wall.

    Turn first; drive when the direction is nearly right.
    """
    for side in learner.random.sample([1, -1], 2):
        drive = goals.goal_behind(learner, side)
        drive.to_the_goal(wall_near=True)
        drive.node.stop()  # two drivers would steer one turtle


@pytest.mark.rules('short-way')
def test_near_goal_behind(learner):
    """The turtle turns to a goal behind it before it drives, also if the goal is near.

    How far the goal is does not say in which direction it is.
    """
    for far in (0.4, learner.random.uniform(0.16, 0.2)):
        drive = goals.near_behind(learner, far)
        drive.turns_on_the_spot()
        drive.node.stop()  # two drivers would steer one turtle
