"""Visible tests of exercise 6.2, a moon."""

import pytest

from helpers.checks.chapter_06.geometry import axis, check_rotation, origin, same, words
from helpers.runner import expect
from helpers.runner.frames import to_matrix

pytestmark = pytest.mark.exercise('6.2')


def test_rate(learner):
    """The moon tells its place every 0.05 s, with the stamp of that moment.

    A timer of the node. now().to_msg() fits into header.stamp.
    """
    heard = learner.tf_listener()
    learner.start('Moon', 3.0, 8.0)
    learner.run(1.0)
    expect(len(heard.transforms) == 20, f'{len(heard.transforms)} transforms came on /tf in 1 s, expected 20.')
    stamp = heard.transforms[-1].header.stamp
    expect((stamp.sec, stamp.nanosec) == (1, 0), f'At time 1 s the stamp is {stamp.sec + stamp.nanosec / 1e9:g} s.')


def test_quarter(learner):
    """Moon(3.0, 8.0) is at (0, 3, 0) in planet after 2 s, and its x axis points to the planet: along -y.

    2 s are a quarter of 8 s.
    """
    heard = learner.tf_listener()
    learner.start('Moon', 3.0, 8.0)
    learner.run(2.0)
    expect(heard.transforms, 'No transform came on /tf.')
    last = heard.transforms[-1]
    expect(
        (last.header.frame_id, last.child_frame_id) == ('planet', 'moon'),
        f'The transform says where `{last.child_frame_id}` is in `{last.header.frame_id}`, expected `moon` in '
        '`planet`.',
    )
    check_rotation(last, 'Use quaternion_from_euler.')
    there = to_matrix(last)
    expect(
        same(origin(there), (0, 3, 0), 1e-3), f'After 2 s the moon is at {words(origin(there))}, expected (0, 3, 0).'
    )
    expect(
        same(axis(there, 'x'), (0, -1, 0), 1e-3),
        f'After 2 s the x axis of the moon points along {words(axis(there, "x"))}, expected (0, -1, 0).',
    )
