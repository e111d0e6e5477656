"""Visible tests of exercise 6.4, a scan on the map."""

import math

import pytest

from helpers.checks.chapter_06.scans import (
    Laser,
    check_long_wait,
    check_many,
    check_no_hits,
    check_standing,
    check_topics,
    check_zero,
)
from helpers.runner import about, expect
from helpers.runner.frames import pose

pytestmark = [pytest.mark.exercise('6.4'), pytest.mark.wiring(type='topics', qos='topics')]
NEWEST = 'This is the newest transform, and not that of the time of the scan.'


@pytest.mark.rules(
    'name', 'topics', 'one-cloud', 'place', 'order', 'stamp', 'range', 'frame', 'time', 'later', 'hopeless'
)
@about('one-cloud')
def test_scans(learner):
    """A robot drives a bend. Its two lasers measure; transforms come earlier, later, or never.

    wait_for_transform_async gives a future, and add_done_callback says what is to be done then.
    """
    draw = learner.random
    there = Laser(
        learner,
        'laser',
        pose(
            draw.uniform(0.1, 0.4),
            draw.uniform(-0.3, 0.3),
            draw.uniform(0.2, 0.9),
            math.pi,
            0.1,
            draw.uniform(0.5, 1.5),
        ),
        (draw.uniform(1, 5), draw.uniform(1, 5), draw.uniform(-3, 3)),
        (1.0, -0.5, 2.0),
    )
    other = f'robot/{draw.choice(["front", "rear", "left"])}_laser'  # a name as several robots have it
    there.add(other, pose(-0.3, draw.uniform(-0.3, 0.3), 0.2, yaw=draw.uniform(2.0, 3.0)))
    expect(there.node.name == '/scan_to_map', f'Your node is called {there.node.name}, expected /scan_to_map.', 'name')
    check_topics(there)
    for _ in range(4):
        there.tell(there.now)
        learner.run(0.1)
    there.tell(there.now)
    limits = zip(draw.sample([0.25, 0.375, 0.5], 3), draw.sample([6.5, 10.75, 64.5], 3), strict=True)
    _check_scan(there, 'laser', 'one-cloud', 1, (0.2, 0.28), next(limits))
    _check_scan(there, other, 'frame', -1, (0.28, 0.36), next(limits))  # this one turns to the right
    _check_scan(there, 'laser', 'one-cloud', 1, (0.05, 0.15), next(limits))  # an older one comes after a newer one
    check_no_hits(there, 0.25)
    check_zero(there, 0.25)
    _check_later(there, other)
    _check_hopeless(there)
    check_long_wait(there)
    check_standing(there)
    check_many(there)


def _distances(there, limits):
    """Hits and what is none, in any order; the limits are hits."""
    draw = there.learner.random
    low, high = limits
    values = [
        math.inf,
        math.nan,
        -draw.uniform(0.3, 3.0),
        0.0,
        low - 0.001,
        high + 0.001,
        low,
        high,
        *(draw.uniform(low + 0.1, high - 0.1) for _ in range(4)),
    ]
    draw.shuffle(values)
    return values


def _check_scan(there, frame, rule, turn, when, limits):
    """The transforms of the time of the scan are there already. `turn`: 1 for a laser that turns to the left."""
    draw = there.learner.random
    then = round(draw.uniform(*when), 9)
    there.clouds.clear()
    step = turn * draw.uniform(0.1, 0.3)
    scan = there.scan(_distances(there, limits), then, draw.uniform(-2.0, -1.0), step, limits, frame)
    there.learner.run(0.1)
    count = len(there.clouds)
    expect(
        count, f'A scan of `{frame}` came, the transforms of its time are there, and no cloud came on /points.', rule
    )
    expect(count == 1, f'One scan came, and {count} clouds, expected one.', rule)
    there.check(scan, there.clouds.messages[0], {0.4: NEWEST})


def _check_later(there, other):
    """Four scans of each laser come, two of each time, and their transform some hundredths of a second later."""
    draw, begin = there.learner.random, there.now
    there.clouds.clear()
    there.tell(begin)
    there.learner.run(0.1)
    scans = [
        there.scan([draw.uniform(0.5, 9.0) for _ in range(hits)], begin + hundredths / 100, frame=frame)
        for hundredths in range(5, 9)
        for frame, hits in (('laser', 3), (other, 4))  # by the number of hits the clouds are told apart
    ]
    expect(not there.clouds.messages, 'A cloud came before the transforms of its time were known.', 'time')
    there.learner.run(0.04)
    there.tell(begin + 0.14)
    there.learner.run(0.2)
    count = len(there.clouds)
    expect(
        count,
        f'{len(scans)} scans came, their transform 0.04 s later, and no cloud. Do not give up when there is no '
        'transform yet, and do not block: the callback that waits keeps the transforms out.',
        'later',
    )
    expect(
        count == len(scans),
        f'{len(scans)} scans of two lasers came, two of each time, their transform 0.04 s later, and {count} clouds, '
        f'expected {len(scans)}: each scan waits for its own transform.',
        'later',
    )
    there.check_all(scans, {begin + 0.14: NEWEST, begin: 'This is the transform of an earlier time.'})


def _check_hopeless(there):
    """One scan is older than all transforms, one is in a frame that nobody knows; good ones come before and after."""
    draw = there.learner.random
    there.clouds.clear()
    scans = [there.scan([draw.uniform(0.5, 9.0) for _ in range(3)], there.now - 0.05)]
    there.scan([2.0, 3.0], -draw.uniform(0.5, 5.0))
    there.scan([2.0, 3.0], 0.1, frame='nowhere')
    there.learner.run(0.1)
    there.tell(there.now)
    scans += [there.scan([draw.uniform(0.5, 9.0) for _ in range(3)], there.now - 0.05)]
    there.learner.run(0.2)
    count = len(there.clouds)
    expect(
        count >= 2,
        'A scan was older than all transforms, one was in an unknown frame. A good one came before and one after '
        f'them, and {count} of these two got a cloud: a good one waits behind the others.',
        'hopeless',
    )
    expect(count == 2, f'Of four scans, two can never have a transform; {count} clouds came.', 'time')
    there.check_all(scans)
