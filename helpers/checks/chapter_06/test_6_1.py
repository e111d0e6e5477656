"""Visible tests of exercise 6.1, a sensor mast."""

import pytest

from helpers.checks.chapter_06 import mast
from helpers.checks.chapter_06.geometry import axis, check_rotation, origin, same, words
from helpers.runner import expect

pytestmark = pytest.mark.exercise('6.1')


def test_late(learner):
    """Whoever comes late hears of all four frames.

    Send them as static transforms, all four in one list.
    """
    late = mast.late_joiner(learner, 1.0, 20.0)
    for child, parent in mast.PARENTS.items():
        there = late.static_transforms[child].header.frame_id
        expect(there == parent, f'The parent of `{child}` is `{there}`, expected `{parent}`.')
        check_rotation(late.static_transforms[child], mast.NOT_TURNED)


def test_camera(learner):
    """The camera of SensorMast(1.0, 20.0) is at (-0.05, 0, 1.2) in base_link and sees (0.89, 0, 0.86) 1 m ahead.

    The tilt is given in degrees; functions want radians. A positive pitch looks down.
    """
    camera = mast.in_base(mast.late_joiner(learner, 1.0, 20.0), 'camera')
    expect(
        same(origin(camera), (-0.05, 0.0, 1.2)),
        f'The camera is at {words(origin(camera))} in base_link, expected (-0.05, 0, 1.2).',
    )
    ahead = origin(camera) + axis(camera, 'x')
    expect(
        same(ahead, (0.8897, 0.0, 0.8580), 1e-3),
        f'1 m ahead of the camera is {words(ahead)} in base_link, expected (0.89, 0, 0.86).',
    )
