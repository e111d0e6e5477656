"""Readings of a distance sensor in centimetres, and what a relay makes of them: for exercise 3.2."""

import math
from collections import Counter

import pytest
from sensor_msgs.msg import Range
from std_msgs.msg import Header

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.runner import about, expect


def reading(random, **changes) -> Range:
    """A measurement in centimetres of these years; all fields are drawn, and no two are equal."""
    message = Range(
        radiation_type=random.randint(1, 99),  # a relay does not ask what kinds there are
        field_of_view=random.uniform(0.1, 6.2),
        range=random.uniform(10, 190),
        variance=random.uniform(1, 9),
        min_range=random.uniform(1, 5),
        max_range=random.uniform(200, 500),
    )
    message.header.frame_id = f'/Sonar_{random.randint(1, 99)}'  # a relay does not ask how a frame is called
    message.header.stamp.sec = random.randint(18 * 10**8, 19 * 10**8)
    message.header.stamp.nanosec = random.randrange(10**9)
    for field, value in changes.items():
        setattr(message, field, value)
    return message


def burst(random) -> list[Range]:
    """Ten messages that are sent one shortly after the other: some have values that somebody might leave out."""
    still = reading(random)  # an object that does not move: each message is one like any other
    return [
        still,
        still,
        # Many metres, as some sensors see.
        reading(random, range=still.range, min_range=random.uniform(300, 900), max_range=random.uniform(2e4, 9e6)),
        reading(random, range=0.0, min_range=0.0, variance=0.0),  # zero is a number like any other
        reading(random, range=random.uniform(0.1, 0.9), min_range=0.0625, max_range=0.9375),  # also centimetres
        reading(random, range=random.uniform(0.1, 0.9), header=Header()),  # nearer than min_range, and no header
        # Limits that are given in the wrong order: that is for others to find out.
        reading(random, range=math.nan, min_range=random.uniform(600, 900), max_range=random.uniform(200, 500)),
        reading(random, range=-random.uniform(1, 5)),
        reading(random, range=-math.inf),  # nearer than the sensor can see, in ROS
        reading(random, range=400.0, max_range=400.0),
    ]


def check_lost(got: list[Range], sent: list[Range]) -> None:
    """Where fewer came out than went in, tell one that is missing; who changes all stamps is told so elsewhere."""
    came = Counter(map(_stamp, got))
    missing = []
    for message in sent:
        came[_stamp(message)] -= 1
        if came[_stamp(message)] < 0:
            missing.append(message)
    if not got or len(got) >= len(sent) or len(missing) != len(sent) - len(got):
        return
    one = missing[0]
    twice = sum(_stamp(other) == _stamp(one) for other in sent) > 1
    values = f'range={one.range:g}, min_range={one.min_range:g} and max_range={one.max_range:g}'
    expect(
        False,
        f'{len(sent)} messages came one shortly after the other, and {len(missing)} of them did not come out, such as '
        f'{"the second of two that are alike" if twice else f"one with {values}"}. Publish one message for each, '
        'whatever is in it.',
        'one-each',
    )


def _stamp(message: Range) -> tuple[int, int]:
    return message.header.stamp.sec, message.header.stamp.nanosec


def check_burst(got: list[Range], sent: list[Range]) -> None:
    """`got` is what came for messages that were sent one shortly after the other; there are as many."""
    came, wanted = ([*map(_stamp, of)] for of in (got, sent))
    same = sorted(came) == sorted(wanted)
    expect(
        same or len(set(came)) == 1 or not set(came) <= set(wanted),  # without a header all are alike
        f'Of {len(wanted)} messages that came one shortly after the other, some came out twice, and others never.',
        'one-each',
    )
    expect(
        came == wanted or not same,
        f'{len(wanted)} messages came one shortly after the other, and yours came out in another order.',
        'at-once',
    )
    for message, original in zip(got, sent, strict=True):
        check_reading(message, original)


def close(value: float, wanted: float) -> bool:
    """Whether a float32 field has this value; infinity equals itself only."""
    return value == pytest.approx(wanted, rel=1e-4)


def check_reading(got: Range, sent: Range) -> None:
    """`got` is `sent`, in metres."""
    for field in ('range', 'min_range', 'max_range'):
        before, after = getattr(sent, field), getattr(got, field)
        if math.isnan(before):
            expect(math.isnan(after), f'{field} was nan (a failed measurement) and became {after:g}.', 'distances')
            continue
        if math.isinf(before):
            expect(
                after == before,
                f'{field} was {before:g} and became {after:g}; {before:g} must stay {before:g}.',
                'inf' if before > 0 else 'distances',
            )
            continue
        expect(
            not before or not close(after, before * 100),
            f'{field}: {before:g} cm became {after:g} m: divide by 100.',
            'distances',
        )
        expect(
            close(after, before / 100),
            f'{field}: {before:g} cm became {after:g} m, expected {before / 100:g} m. Convert all three distances.',
            'distances',
        )
    expect(
        not close(got.variance, sent.variance / 100) or not sent.variance,
        f'The variance {sent.variance:g} was divided by 100. It is a square: divide by 100 squared.',
        'variance',
    )
    expect(
        close(got.variance, sent.variance / 1e4),
        f'The variance {sent.variance:g} cm² became {got.variance:g}, expected {sent.variance / 1e4:g} m².',
        'variance',
    )
    expect(
        got.header.frame_id == sent.header.frame_id,
        f'header.frame_id was {sent.header.frame_id!r} and became {got.header.frame_id!r}: the header is lost.',
        'header',
    )
    expect(
        got.header.stamp == sent.header.stamp,
        'header.stamp has changed: it says when the measurement was made, not when it was converted.',
        'header',
    )
    expect(
        close(got.field_of_view, sent.field_of_view),
        f'field_of_view was {sent.field_of_view:g} and became {got.field_of_view:g}: it is an angle, and stays as '
        'it is.',
        'others',
    )
    expect(
        got.radiation_type == sent.radiation_type,
        f'radiation_type was {sent.radiation_type} and became {got.radiation_type}: copy the fields that you do not '
        'convert.',
        'others',
    )


def check_own_topic(learner, relay, heard, sensor) -> None:
    """A relay publishes on its own topic, which is `heard`, when another one has been made in another namespace."""
    others = learner.listen(f'{OTHER}/sonar', Range)
    with about('one-each'):
        learner.start('RangeToMetres', beside=relay, remap={'__ns': OTHER})
        learner.settle()
        for recorded in (heard, others):
            recorded.clear()
        sensor.send(reading(learner.random))
        learner.settle()
    learner.wait_until(lambda: heard.messages or others.messages, 0.5)
    story = 'A message went in to the first one'
    check_own('RangeToMetres', story, len(heard), len(others), 'sonar', 'publisher', 'topics')
