"""Visible tests of exercise 8.9, go to a station."""

import pytest

from helpers.checks.chapter_08 import drives, held_robot, two_at_once
from helpers.runner import about

pytestmark = [pytest.mark.exercise('8.9'), pytest.mark.wiring(type='rhythm', qos='rhythm', namespace='action')]


@pytest.mark.rules(
    'rejects-unknown', 'single', 'state', 'rhythm', 'limits', 'feedback', 'cancel', 'stands', 'result', 'succeeds'
)
def test_drive(learner):
    """The robot rejects what it must, drives, is called back, stands, and drives again.

    Every 0.1 s: where(), steer(), drive(). What every end needs stands behind the loop.
    """
    yaw = learner.random.choice([-1, 1]) * learner.random.uniform(2.5, 2.9)
    there = drives.Drives(learner, (0.0, 0.0, yaw))
    with about('rhythm'):
        name = drives.judge_rejections(there)
        drives.judge_turning(there)
        drives.judge_driving(there, name)
    with about('cancel'):
        drives.judge_cancel(there, name)


@pytest.mark.rules('action')
def test_name(learner):
    """In a namespace, the action is in it.

    'go_to_station', without a slash at its beginning.
    """
    drives.judge_name(learner)


@pytest.mark.rules('succeeds', 'rhythm', 'timeout', 'result', 'stands', 'lost', 'feedback')
def test_held(learner):
    """A robot that is held drives with what steer says, gives up in time, and has arrived below the tolerance.

    steer(*where(), ...), drive(...); distance < tolerance, wherever the robot looks.
    """
    held_robot.judge_held(learner, learner.random.uniform(9.0, 11.0))


@pytest.mark.rules('rejects-lost', 'lost', 'timeout', 'next', 'succeeds', 'result')
def test_lost_and_late(learner):
    """A robot that is lost, or takes too long, gives up, stands, and takes the next goal.

    where() is None: drive(0.0, 0.0), abort(). The same when timeout seconds are over.
    """
    timeout = learner.random.choice([2.5, 3.0, 3.5])
    there = drives.Drives(learner, timeout=timeout)
    with about('lost'):
        drives.judge_lost(there)
    with about('timeout'):
        drives.judge_timeout(there, timeout)


@pytest.mark.rules('single', 'next', 'succeeds')
def test_two_goals(learner):
    """Of two goals of one moment one is accepted, wherever its callback stands just then; again and again.

    The look at self.state and its change belong together: in one callback group, or under one lock.
    """
    two_at_once.judge_two_goals(learner)


@pytest.mark.rules('state', 'single', 'action', 'next')
def test_two_robots(learner):
    """What one robot does is nothing to another robot in the same program.

    self.state = ..., in the object.
    """
    two_at_once.judge_two_robots(learner)
