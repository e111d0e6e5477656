"""Hidden tests of exercise 8.9, go to a station."""

import math

import pytest

from helpers.checks.chapter_08.drives import (
    TOLERANCE,
    Drives,
    judge_arrived,
    judge_cancel,
    judge_driving,
    judge_lost,
    judge_name,
    judge_rejections,
    judge_timeout,
    judge_turning,
)
from helpers.checks.chapter_08.held_robot import judge_held
from helpers.checks.chapter_08.two_at_once import judge_two_goals, judge_two_robots
from helpers.runner import about

pytestmark = [pytest.mark.exercise('8.9'), pytest.mark.wiring(type='rhythm', qos='rhythm', namespace='action')]


@pytest.mark.rules('action')
def test_name(learner):
    """In a namespace, the action is in it.

    'go_to_station', without a slash at its beginning.
    """
    judge_name(learner)


@pytest.mark.rules('succeeds', 'stands', 'result', 'next', 'state', 'rhythm')
@pytest.mark.weight(3)
def test_arrives(learner):
    """The robot reaches stations in any direction, stands there, and says how near it is.

    Every 0.1 s: where(), steer(), drive(), always with the newest place.
    """
    draw = learner.random
    drives = Drives(learner, (0.0, 0.0, draw.uniform(-3, 3)))
    with about('succeeds'):
        for name, length, angle in (
            ('one', draw.uniform(0.7, 1.0), draw.uniform(-0.5, 0.5)),
            ('two', draw.uniform(0.7, 1.0), math.pi + draw.uniform(-0.5, 0.5)),
            ('three', 0.5, draw.uniform(-0.5, 0.5)),
        ):
            drives.delivery.station(name, length * math.cos(angle), length * math.sin(angle))
            goal = drives.go(name, 'next', f'The goal before {name} has ended')
            drives.run(15.0, goal)
            judge_arrived(drives, goal, name, TOLERANCE)


@pytest.mark.rules('rejects-unknown', 'single', 'state', 'rhythm', 'limits', 'feedback')
@pytest.mark.weight(6)
def test_drive(learner):
    """The robot rejects what it must, tells where it goes, and drives with the limits that hold now.

    Set self.state in the goal callback: two goals may come at one moment. Read a parameter when you need it.
    """
    drives = Drives(learner, (0.0, 0.0, learner.random.choice([-1, 1]) * learner.random.uniform(2.5, 2.9)))
    with about('rhythm'):
        name = judge_rejections(drives)
        judge_turning(drives)
        judge_driving(drives, name)


@pytest.mark.rules('cancel', 'stands', 'result', 'next', 'state')
@pytest.mark.weight(3)
def test_cancel(learner):
    """A cancelled goal ends within 0.2 s; the robot stands; the result has what is left; the next goal succeeds.

    Look at is_cancel_requested in each round. What every end needs stands behind the loop.
    """
    drives = Drives(learner)
    with about('cancel'):
        drives.delivery.station('far', 3.0, learner.random.uniform(-0.3, 0.3))
        drives.goal = drives.go('far', 'next', 'No other goal runs')
        drives.run(learner.random.uniform(1.2, 1.8))
        judge_cancel(drives, 'far')


@pytest.mark.rules('succeeds', 'rhythm', 'timeout', 'result', 'stands', 'lost', 'feedback')
def test_held(learner):
    """A robot that is held drives with what steer says, gives up in time, and has arrived below the tolerance."""
    judge_held(learner, learner.random.uniform(18.0, 20.0))


@pytest.mark.rules('rejects-lost', 'lost', 'timeout', 'next', 'succeeds', 'result')
@pytest.mark.weight(5)
def test_lost_and_late(learner):
    """A robot that is lost, or takes too long, gives up, stands, and takes the next goal.

    where() is None: drive(0.0, 0.0), abort(). A goal is rejected as long as where() is None.
    """
    timeout = learner.random.choice([2.0, 2.8, 4.0])
    drives = Drives(learner, timeout=timeout)
    with about('lost'):
        judge_lost(drives)
    with about('timeout'):
        judge_timeout(drives, timeout)


@pytest.mark.rules('single', 'next', 'succeeds')
@pytest.mark.weight(2)
def test_two_goals(learner):
    """Of two goals of one moment one is accepted, wherever its callback stands just then; again and again."""
    judge_two_goals(learner)


@pytest.mark.rules('state', 'single', 'action', 'next')
def test_two_robots(learner):
    """What one robot does is nothing to another robot in the same program."""
    judge_two_robots(learner)
