"""Hidden tests of exercise 8.8, where am I?"""

import math

import pytest

from helpers.checks.chapter_08.deliveries import Localizer, where
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.8')


def begin(learner):
    """A node, and a localiser whose odom has drifted."""
    draw = learner.random
    localizer = Localizer(learner, (draw.uniform(0.5, 1), -draw.uniform(0.5, 1), draw.uniform(2, 3)))
    node = learner.start('Courier')
    learner.run(0.2)
    return localizer, node


def same(found, wanted):
    return found is not None and list(found) == pytest.approx(wanted, abs=1e-4)


@pytest.mark.weight(3)
def test_place(learner):
    """where() gives x and y of base_footprint in map.

    The first argument of lookup_transform is the frame in which you want to know the place.
    """
    localizer, node = begin(learner)
    draw = learner.random
    for _ in range(2):
        x, y, yaw = draw.uniform(1, 3), draw.uniform(1, 3), draw.uniform(0.5, 1)
        localizer.tell(x, y, yaw)
        learner.run(0.1)
        found = where(node)
        expect(found is not None, f'The robot is at ({x:.2f}, {y:.2f}), tf2 knew it 0.1 s ago, and where() is None.')
        swapped = [-x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) - y * math.cos(yaw)]
        told = f'The robot is at ({x:.2f}, {y:.2f}), and where() says ({found[0]:.2f}, {found[1]:.2f}).'
        expect(not same(found[:2], swapped), f'{told} That is the map in the frame of the robot: target and source '
                                             'are swapped.')
        expect(same(found[:2], [x, y]), f'{told} Which frames did you ask for?')


@pytest.mark.weight(2)
def test_yaw(learner):
    """The yaw is right in all directions, from -π to π.

    A quaternion and its negative are the same turn. math.remainder(…, math.tau).
    """
    localizer, node = begin(learner)
    for low, high in ((-3.1, -2.0), (-1.5, -0.5), (0.5, 1.5), (2.0, 3.1)):
        yaw = learner.random.uniform(low, high)
        localizer.tell(1.0, 1.0, yaw)
        learner.run(0.1)
        found = where(node)
        expect(found is not None, 'tf2 knows where the robot is, and where() is None.')
        expect(same(found[2:], [yaw]), f'The robot looks to {yaw:.2f} rad, and where() says {found[2]:.2f} rad.')


@pytest.mark.weight(2)
def test_unknown(learner):
    """Nothing is known, or only half of the way: where() is None, at once, without an exception.

    Catch TransformException: several errors of tf2 have it as their base.
    """
    broadcaster = learner.tf_broadcaster()
    from helpers.runner.frames import pose

    node = learner.start('Courier')
    learner.run(0.2)
    expect(where(node) is None, 'No transform has come, and where() is not None.')
    broadcaster.send('map', 'odom', pose(1.0))
    learner.run(0.1)
    expect(where(node) is None, 'Only odom in map is known, and where() is not None: nobody knows where the robot is '
                                'in odom.')


@pytest.mark.weight(3)
def test_old(learner):
    """A place that is older than 0.5 s is None; a new one counts again.

    Time() asks for the newest transform, however old it is. Compare its stamp with the clock of the node.
    """
    localizer, node = begin(learner)
    localizer.tell(1.0, 2.0, 0.5)
    learner.run(0.45)
    expect(where(node) is not None, 'The transforms are 0.45 s old, and where() is None. That is good enough.')
    learner.run(learner.random.uniform(0.2, 0.8))
    found = where(node)
    expect(found is None, f'The transforms are more than 0.5 s old, and where() still says {found}. Look at their '
                          'stamp.')
    localizer.tell(1.5, 2.0, 0.5)
    learner.run(0.1)
    expect(same(where(node), [1.5, 2.0, 0.5]), f'The transforms came again, and where() is {where(node)}, expected '
                                               '(1.5, 2.0, 0.5).')
