"""Hidden tests of exercise 1.4, drive the turtle to a goal."""

import pytest

from helpers.checks.chapter_01 import goals

pytestmark = [pytest.mark.exercise('1.4'), pytest.mark.wiring(type='topics', qos='topics', namespace='topics')]


@pytest.mark.weight(3)
@pytest.mark.rules('reach', 'stop')
def test_any_goal(learner):
    """From any place and heading to any goal, and there it stays.

    Decide anew at each pose: the place and the heading are in the message.
    """
    for straight in (True, False):
        drive = goals.any_goal(learner, straight=straight)
        drive.to_the_goal()
        drive.stays(2.0)
        drive.node.stop()  # two drivers would steer one turtle
    goals.across_the_world(learner).to_the_goal()


@pytest.mark.weight(2)
@pytest.mark.rules('short-way')
def test_short_way_left(learner):
    """The turtle turns the short way to the left, where the angle jumps from π to −π.

    math.remainder(error, 2 * math.pi) brings the error into −π … π.
    """
    goals.across_pi(learner, 1)


@pytest.mark.rules('short-way')
def test_short_way_right(learner):
    """The turtle turns the short way to the right, where the angle jumps from −π to π.

    math.remainder(error, 2 * math.pi) brings the error into −π … π.
    """
    goals.across_pi(learner, -1)


@pytest.mark.weight(2)
@pytest.mark.rules('walls', 'short-way')
def test_a_goal_behind(learner):
    """A goal behind the turtle, near a wall, is reached without touching a wall.

    Turn first; drive when the direction is nearly right.
    """
    for side in (1, -1):
        drive = goals.goal_behind(learner, side)
        drive.to_the_goal(wall_near=True)
        drive.node.stop()  # two drivers would steer one turtle


@pytest.mark.rules('node', 'topics', 'reach')
def test_names(learner):
    """The topics are relative, the node is called go_to_goal, and two of them drive to two goals.

    No slash at the beginning of a topic's name; what belongs to one object is kept in self.
    """
    drive = goals.any_goal(learner, f'/sim{learner.random.randint(2, 9)}')
    drive.check_ends()
    drive.begin_another()
    drive.to_the_goal()
    drive.other_one_drives()


@pytest.mark.rules('stop')
def test_at_the_goal_already(learner):
    """Who starts at the goal stands still at once.

    math.atan2(0, 0) is 0, and that is no direction to drive in.
    """
    goals.there_already(learner).stays(1.0)


@pytest.mark.rules('short-way')
def test_near_goal_behind(learner):
    """The turtle turns to a goal behind it before it drives, also if the goal is near.

    How far the goal is does not say in which direction it is.
    """
    for far in (0.4, learner.random.uniform(0.16, 0.2)):
        drive = goals.near_behind(learner, far)
        drive.turns_on_the_spot()
        drive.node.stop()  # two drivers would steer one turtle
