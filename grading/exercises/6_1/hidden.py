"""Hidden tests of exercise 6.1, a sensor mast."""

import math

import numpy as np
import pytest

from helpers.checks.chapter_06 import mast
from helpers.checks.chapter_06.geometry import axis, check_rotation, explain, origin, same, words
from helpers.runner import expect
from helpers.runner.frames import to_matrix

pytestmark = pytest.mark.exercise('6.1')


def begin(learner):
    """A mast of another height and tilt; returns what a late listener hears, and both numbers."""
    height, tilt = round(learner.random.uniform(0.6, 2.5), 2), 0.0
    while abs(math.sin(tilt) - math.sin(math.radians(tilt))) < 0.2:  # some degrees look the same as radians
        tilt = round(learner.random.uniform(25, 50), 1)
    return mast.late_joiner(learner, height, tilt), height, tilt


@pytest.mark.weight(2)
def test_tree(learner):
    """The four frames are a tree as in the table, and whoever comes late hears of all of it.

    header.frame_id is the parent, child_frame_id the child. A StaticTransformBroadcaster, and one list.
    """
    late, _, _ = begin(learner)
    heard = late.static_transforms
    for child, parent in mast.PARENTS.items():
        there = heard[child].header.frame_id
        expect(there == parent, f'The parent of `{child}` is `{there}`, expected `{parent}`.')
    others = sorted(set(heard) - set(mast.PARENTS))
    expect(not others, f'There is one more frame, `{others and others[0]}`.')
    for transform in heard.values():
        check_rotation(transform, mast.NOT_TURNED)


@pytest.mark.weight(2)
def test_places(learner):
    """Each frame is where the table says, for any height.

    A place is given in the frame of the parent: the camera on the mast, not in base_link.
    """
    late, height, tilt = begin(learner)
    for child, expected in mast.truth(height, tilt).items():
        place = origin(to_matrix(late.static_transforms[child]))
        expect(
            same(place, origin(expected)),
            f'SensorMast({height}, {tilt}): `{child}` is at {words(place)} in its parent, expected '
            f'{words(origin(expected))}.',
        )


@pytest.mark.weight(2)
def test_camera(learner):
    """The camera looks down by the tilt, which is in degrees.

    Convert with math.radians. By the right-hand rule a positive pitch turns the nose down.
    """
    late, height, tilt = begin(learner)
    there = mast.in_base(late, 'camera')
    view, angle = axis(there, 'x'), math.radians(tilt)
    told = f'SensorMast({height}, {tilt}): the camera looks along {words(view)} in base_link'
    expected = math.cos(angle), 0, -math.sin(angle)
    explain(
        same(view, expected),
        f'{told}, expected {words(expected)}.',
        (
            same(view, (math.cos(angle), 0, math.sin(angle))),
            'That is up. Positive angles turn from z to x: a positive pitch looks down.',
        ),
        (same(view, (math.cos(tilt), 0, -math.sin(tilt))), 'The tilt was taken for radians. It is in degrees.'),
        (True, 'Which angle is it, and in which order does a Quaternion have x, y, z and w?'),
    )


def test_lidar(learner):
    """The lidar hangs upside down: it looks ahead, its left is the robot's right, and its z points to the floor.

    Half a turn about x: the roll is pi.
    """
    late, _, _ = begin(learner)
    lidar = mast.in_base(late, 'lidar')
    expect(not same(lidar[:3, :3], np.eye(3)), 'The lidar stands upright. It hangs upside down.')
    for name, expected in (('x', (1, 0, 0)), ('y', (0, -1, 0)), ('z', (0, 0, -1))):
        expect(
            same(axis(lidar, name), expected),
            f'The {name} axis of the lidar points along {words(axis(lidar, name))} in base_link, expected '
            f'{words(expected)}. In which order does a Quaternion have x, y, z and w?',
        )


@pytest.mark.weight(2)
def test_optical(learner):
    """In camera_optical, z looks where the camera looks, x to the right, and y down.

    Two quarter turns: a roll and a yaw, both negative.
    """
    late, _, _ = begin(learner)
    optical = late.matrix('camera', 'camera_optical')
    expect(optical is not None, 'tf2 finds no way from `camera_optical` to `camera`.')
    for name, where, expected in (
        ('z', 'ahead', (1, 0, 0)),
        ('x', 'to the right', (0, -1, 0)),
        ('y', 'down', (0, 0, -1)),
    ):
        expect(
            same(axis(optical, name), expected),
            f'The {name} axis of camera_optical points along {words(axis(optical, name))} in the frame camera. '
            f'Expected {where}: {words(expected)}.',
        )
