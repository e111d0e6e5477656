"""Hidden tests of exercise 6.2, a moon."""

import pytest

from helpers.checks.chapter_06 import moons
from helpers.checks.chapter_06.test_6_2 import test_one_look  # noqa: F401 - it draws other inputs here

pytestmark = pytest.mark.exercise('6.2')


@pytest.mark.rules('circle', 'time')
@pytest.mark.weight(2)
def test_circle(learner):
    """At each time the moon is at its place on the circle, whenever the node was started.

    The angle comes from the clock: 2 pi times the time by the period. Not from a counter, and not from the start.
    """
    moon = moons.Watched(learner, 2.0, rounds=True)
    moons.judge_circle(moon)
    moons.judge_two(learner, moon)


@pytest.mark.rules('face')
@pytest.mark.weight(2)
def test_face(learner):
    """The x axis of the moon points to the planet, and its z axis up; the quaternion is one.

    The moon stands at the angle a and looks back: its yaw is a + pi. Radians. A Quaternion has x, y, z and then w.
    """
    moons.judge_face(moons.Watched(learner, 1.0, rounds=True))


@pytest.mark.rules('stamp')
@pytest.mark.weight(2)
def test_stamp(learner):
    """The stamp is the time of the node's clock for which the place was computed.

    Without it nobody can look up where the moon was. time.time() is another clock.
    """
    moons.judge_stamp(moons.Watched(learner, 1.0, rounds=True))


@pytest.mark.rules('rate', 'name', 'frames')
def test_rate(learner):
    """20 transforms come in each second.

    create_timer takes a period in seconds, on the clock of the node.
    """
    moon = moons.Watched(learner, 3.0)
    moons.judge_rate(moon)
    moons.judge_goes_on(learner, moon, 31.0)
