"""Hidden tests of exercise 6.2, a moon."""

import math

import numpy as np
import pytest

from helpers.checks.chapter_06.geometry import axis, check_rotation, explain, origin, same, words
from helpers.runner import expect
from helpers.runner.frames import to_matrix

pytestmark = pytest.mark.exercise('6.2')


def watch(learner, seconds: float = 2.0):
    """Start a moon at some time; returns its radius, its period, and pairs (time of arrival, transform)."""
    draw = learner.random
    radius, period = round(draw.uniform(1.5, 9.0), 1), round(draw.uniform(5.0, 15.0), 1)
    learner.run(round(draw.uniform(0.2, 0.4) * period, 2))  # the node starts when the moon is somewhere else
    heard = learner.tf_listener()
    node = learner.start('Moon', radius, period)
    learner.run(seconds)
    expect(node.name == '/moon', f'Your node is called {node.name}, expected /moon.')
    expect(
        not heard.static_transforms,
        'Transforms came on /tf_static. That is for frames that never move: use a TransformBroadcaster.',
    )
    expect(heard.transforms, 'No transform came on /tf.')
    for transform in heard.transforms:
        names = transform.header.frame_id, transform.child_frame_id
        expect(
            names != ('moon', 'planet'),
            'Your transform says where `planet` is in `moon`. Parent and child are '
            'swapped: header.frame_id is the parent.',
        )
        expect(
            names == ('planet', 'moon'),
            f'Your transform says where `{names[1]}` is in `{names[0]}`, expected `moon` in `planet`.',
        )
    pairs = zip(heard.moving.stamps, heard.moving.messages, strict=True)
    return radius, period, [(time, transform) for time, message in pairs for transform in message.transforms]


@pytest.mark.weight(2)
def test_circle(learner):
    """At each time the moon is at its place on the circle, whenever the node was started.

    The angle comes from the clock: 2 pi times the time by the period. Not from a counter, and not from the start.
    """
    radius, period, pairs = watch(learner)
    start = pairs[0][0]
    for time, transform in pairs:

        def place(angle):
            return radius * math.cos(angle), radius * math.sin(angle), 0.0

        angle, there = 2 * math.pi * time / period, origin(to_matrix(transform))
        late = any(same(there, place(2 * math.pi * (time - start + delay) / period), 1e-3) for delay in (0.0, 0.05))
        explain(
            same(there, place(angle), 1e-3),
            f'Moon({radius}, {period}): at time {time:g} s the moon is at {words(there)}, expected '
            f'{words(place(angle))}.',
            (late, 'It started on the x axis when the node was made. Its place depends on the time of the clock only.'),
            (same(there, place(-angle), 1e-3), 'It goes round to the right, expected to the left: from x to y.'),
        )


@pytest.mark.weight(2)
def test_face(learner):
    """The x axis of the moon points to the planet, and its z axis up; the quaternion is one.

    The moon stands at the angle a and looks back: its yaw is a + pi. Radians. A Quaternion has x, y, z and then w.
    """
    radius, period, pairs = watch(learner, 1.0)
    for time, transform in pairs:
        check_rotation(transform, 'An angle is not a part of a quaternion. Use quaternion_from_euler.')
        there, angle = to_matrix(transform), 2 * math.pi * time / period
        view, expected = axis(there, 'x'), np.array((-math.cos(angle), -math.sin(angle), 0.0))
        told = f'Moon({radius}, {period}): at time {time:g} s the x axis of the moon points along {words(view)}'
        expect(
            same(axis(there, 'z'), (0, 0, 1)),
            f'{told}, and its z axis along {words(axis(there, "z"))}, expected '
            '(0, 0, 1). In which order does a Quaternion have x, y, z and w?',
        )
        explain(
            same(view, expected, 1e-3),
            f'{told}, expected to the planet: {words(expected)}.',
            (same(view, (1, 0, 0)), 'It never turns.'),
            (same(view, -expected, 1e-3), 'It looks away from the planet: half a turn is missing.'),
            (True, 'Is an angle in degrees, or is half an angle missing?'),
        )


@pytest.mark.weight(2)
def test_stamp(learner):
    """The stamp is the time of the node's clock for which the place was computed.

    Without it nobody can look up where the moon was. time.time() is another clock.
    """
    _, _, pairs = watch(learner, 1.0)
    for time, transform in pairs:
        stamp = transform.header.stamp.sec + transform.header.stamp.nanosec / 1e9
        expect(
            stamp != 0,
            'The stamp of a transform is 0: it was not filled in. So tf2 cannot tell when the moon was there.',
        )
        expect(stamp < 1e9, f'The stamp is {stamp:.0f} s: the time of the wall. Use the clock of the node.')
        expect(same(stamp, time), f'At time {time:g} s the stamp is {stamp:g} s.')


def test_rate(learner):
    """20 transforms come in each second.

    create_timer takes a period in seconds, on the clock of the node.
    """
    _, _, pairs = watch(learner, 3.0)
    expect(len(pairs) == 60, f'{len(pairs)} transforms came in 3 s, expected 60.')
    gaps = np.diff([time for time, _ in pairs])
    expect(
        same(gaps, np.full(59, 0.05)),
        f'Between two transforms there were {gaps.min():g} to {gaps.max():g} s, expected 0.05 s.',
    )
