"""Visible tests of exercise 6.4, a scan on the map."""

import pytest

from helpers.checks.chapter_06.scans import Laser
from helpers.runner import expect

pytestmark = pytest.mark.exercise('6.4')


def test_hits(learner):
    """The laser is at (2, 1, 0.5) and looks along the map's y axis: a hit 3 m ahead is at (2, 4, 0.5).

    x = distance * cos(angle), y = distance * sin(angle), z = 0; then into the map.
    """
    laser = Laser(learner)
    laser.tell(0.0)
    scan = laser.scan([3.0, 2.0], 0.0, first=0.0)
    learner.run(0.1)
    expect(laser.clouds.messages, 'A scan came and its transform is there, and no cloud came on /points.')
    laser.check(scan, laser.clouds.messages[0])


def test_no_hits(learner):
    """Distances outside of range_min to range_max, such as inf, are left out.

    They say that nothing was hit. Note the angles of the others.
    """
    laser = Laser(learner)
    laser.tell(0.0)
    scan = laser.scan([float('inf'), 2.0, 0.05, 3.0, float('nan')], 0.0)
    learner.run(0.1)
    expect(laser.clouds.messages, 'A scan came and its transform is there, and no cloud came on /points.')
    laser.check(scan, laser.clouds.messages[0])


def test_transform_comes_later(learner):
    """A scan comes, and its transform a moment later: then the cloud comes.

    wait_for_transform_async gives a future, and add_done_callback says what is to be done then.
    """
    laser = Laser(learner, speed=(0.5, 0.0, 0.4))
    laser.tell(0.0)
    learner.run(0.1)
    scan = laser.scan([3.0, 2.0], 0.1)
    learner.run(0.05)
    expect(not laser.clouds.messages, 'A cloud came before the transform of its time was known.')
    laser.tell(0.15)
    learner.run(0.1)
    expect(laser.clouds.messages, 'The transform came 0.05 s after the scan, and then no cloud came. Do not give up, '
                                  'and do not block: the callback that waits keeps the transforms out.')
    laser.check(scan, laser.clouds.messages[0])
