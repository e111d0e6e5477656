"""Visible tests of exercise 6.2, a moon."""

import pytest

from helpers.checks.chapter_06 import moons

pytestmark = pytest.mark.exercise('6.2')


@pytest.mark.rules('name', 'frames', 'rate', 'stamp')
def test_rate(learner):
    """The moon tells its place in the planet every 0.05 s, with the stamp of that moment.

    A timer of the node. now().to_msg() fits into header.stamp.
    """
    moon = moons.Watched(learner, 1.0)
    moons.judge_rate(moon)
    moons.judge_goes_on(learner, moon, learner.random.uniform(6.0, 8.0))
    moons.judge_stamp(moon)


@pytest.mark.rules('circle', 'time', 'face', 'stamp')
def test_circle(learner):
    """At each time the moon is at its place on the circle, and its x axis points to the planet.

    The angle comes from the clock: 2 pi times the time by the period. A moon at the angle a looks back: its yaw is
    a + pi.
    """
    moon = moons.Watched(learner, 2.0, rounds=True)
    moons.judge_circle(moon)
    moons.judge_face(moon)
    moons.judge_stamp(moon)
    moons.judge_two(learner, moon)


@pytest.mark.rules('stamp', 'face')
def test_one_look(learner):
    """Place, turn and stamp are those of one time, also when the clock goes on in the middle of a callback.

    Ask the clock once in each callback, keep what it says in a variable, and use this for all.
    """
    moons.judge_one_look(learner)
