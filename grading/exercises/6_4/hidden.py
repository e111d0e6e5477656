"""Hidden tests of exercise 6.4, a scan on the map."""

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
    points,
)
from helpers.runner import about, expect
from helpers.runner.frames import pose

pytestmark = [pytest.mark.exercise('6.4'), pytest.mark.wiring(type='topics', qos='topics')]


def laser(learner, speed=(0.0, 0.0, 0.0)) -> Laser:
    """A laser of any name, mounted anyhow on a robot that stands anywhere."""
    draw = learner.random
    mount = pose(
        draw.uniform(0.1, 0.5),
        draw.uniform(-0.3, 0.3),
        draw.uniform(0.2, 1.0),
        draw.choice([0.0, math.pi]),
        draw.uniform(-0.3, 0.3),
        draw.uniform(0.5, 2.5),
    )
    return Laser(
        learner,
        f'{draw.choice(["front", "rear", "left"])}_laser',
        mount,
        (draw.uniform(1, 5), draw.uniform(1, 5), draw.uniform(-3, 3)),
        speed,
    )


def ranges(learner, count=8):
    return [learner.random.uniform(0.5, 9.0) for _ in range(count)]


def only(there: Laser, what: str):
    """The one cloud that comes, within 0.1 s."""
    there.learner.run(0.1)
    count = len(there.clouds)
    expect(count, f'{what}, and no cloud came on /points.')
    expect(count == 1, f'{what}, and {count} clouds came, expected one for each scan.')
    return there.clouds.messages[0]


@pytest.mark.weight(3)
@pytest.mark.rules('name', 'topics', 'one-cloud', 'place', 'order', 'stamp', 'frame')
@about('one-cloud')
def test_hits(learner):
    """Each hit of a scan is a point of the cloud, in the map, wherever the laser is mounted.

    Distance and angle give x and y in the frame of the scan's header; target of the look-up is the map.
    """
    there = laser(learner)
    expect(there.node.name == '/scan_to_map', f'Your node is called {there.node.name}, expected /scan_to_map.', 'name')
    there.tell(0.0)
    learner.run(0.2)
    there.tell(0.2)
    check_topics(there)
    scan = there.scan(ranges(learner), 0.1, learner.random.uniform(-2.0, -1.0), learner.random.uniform(0.1, 0.3))
    there.check(scan, only(there, 'A scan came, the transforms of its time are there'))


@pytest.mark.weight(2)
@pytest.mark.rules('time', 'frame', 'one-cloud')
@about('one-cloud')
def test_time_of_the_scan(learner):
    """The robot turns fast. The cloud is where the laser was when it measured.

    Look up at the stamp of the scan: not at Time(), which is the newest, and not at now.
    """
    there = laser(learner, speed=(1.0, -0.5, 2.0))
    for _ in range(5):
        there.tell(there.now)
        learner.run(0.1)
    there.tell(0.5)
    then = round(learner.random.uniform(0.12, 0.28), 9)
    scan = there.scan(ranges(learner), then)
    there.check(
        scan,
        only(there, 'A scan came, the transforms of its time are there'),
        {0.5: 'This is the newest transform, and not that of the time of the scan.'},
    )


@pytest.mark.weight(2)
@pytest.mark.rules('later', 'time')
@about('later')
def test_transform_comes_later(learner):
    """The transforms come after the scan, as they do on every robot. Then the cloud comes, once, and right.

    A callback that waits for a transform keeps it out: nobody else can run.
    """
    there = laser(learner, speed=(1.0, -0.5, 2.0))
    there.tell(0.0)
    learner.run(0.1)
    then = round(learner.random.uniform(0.06, 0.1), 3)
    scan = there.scan(ranges(learner), then)
    expect(not there.clouds.messages, 'A cloud came before the transforms of its time were known.', 'time')
    learner.run(0.04)
    there.tell(0.14)
    cloud = only(
        there, 'A scan came, and its transform 0.04 s later. A look-up that gives up, or that blocks, never sees it'
    )
    there.check(
        scan,
        cloud,
        {
            0.0: 'This is the transform of an earlier time.',
            0.14: 'This is the newest transform, and not that of the time of the scan.',
        },
    )
    check_long_wait(there)


@pytest.mark.rules('range', 'one-cloud', 'place')
@about('one-cloud')
def test_no_hits(learner):
    """What is not from range_min to range_max is no hit and is left out; the limits themselves are hits.

    Compare with the fields of the message. Comparisons with nan are False.
    """
    there = laser(learner)
    there.tell(0.0)
    draw = learner.random.uniform
    no_hits = [math.inf, math.nan, draw(0.0, 0.09), draw(12.1, 30.0), -draw(0.2, 3.0), 0.0, -math.inf]
    learner.random.shuffle(no_hits)
    mixed = [value for pair in zip(no_hits, ranges(learner, 7), strict=True) for value in pair]
    scan = there.scan([*mixed, 12.0], 0.0)
    cloud = only(there, 'A scan came with hits and with inf')
    found = points(cloud)
    expect(
        len(found) != len(scan.ranges),
        'The cloud has a point for each distance, also for inf and nan. These say that nothing was hit.',
        'range',
    )
    there.check(scan, cloud)
    check_no_hits(there, 0.0)
    check_zero(there, 0.0)
    check_standing(there)


@pytest.mark.weight(2)
@pytest.mark.rules('hopeless')
@about('hopeless')
def test_hopeless(learner):
    """The first scan is older than all transforms: it never gets a cloud. The next ones do.

    Do not let one scan wait in front of the others.
    """
    there = laser(learner, speed=(0.5, 0.5, 1.0))
    learner.run(1.0)
    there.scan(ranges(learner), round(learner.random.uniform(0.2, 0.8), 2))
    for _ in range(3):
        there.tell(there.now)
        learner.run(0.1)
    there.tell(1.3)
    scans = [there.scan(ranges(learner), seconds) for seconds in (1.05, 1.25)]
    learner.run(0.2)
    expect(
        there.clouds.messages,
        'One scan was older than all transforms. Two good ones came after it, and they got '
        'no cloud: they wait behind the first one.',
    )
    expect(
        len(there.clouds) == 2,
        f'Of three scans, one was older than all transforms; {len(there.clouds)} clouds came, expected 2.',
    )
    for scan, cloud in zip(scans, there.clouds.messages, strict=True):
        there.check(scan, cloud)


@pytest.mark.rules('range')
@about('range')
def test_limits(learner):
    """Each scan has limits of its own; the limits themselves are hits.

    range_min and range_max are fields of the message.
    """
    there = laser(learner)
    there.tell(0.0)
    for limits in ((0.25, 4.5), (1.5, 30.0), (0.0, 6.0), (2.0, 64.5)):
        there.clouds.clear()
        values = [*limits, limits[0] - 0.001, limits[1] + 0.001, 0.1875, 1.0, 4.0, 4.75, 29.0, 40.0, 63.0]
        learner.random.shuffle(values)
        scan = there.scan(values, 0.0, limits=limits)
        there.check(scan, only(there, 'A scan came'))


@pytest.mark.rules('later')
@about('later')
def test_several_wait(learner):
    """Three scans wait for one transform: each gets its cloud.

    What waits is kept for each scan, not in one attribute.
    """
    there = laser(learner, speed=(1.0, -0.5, 2.0))
    there.tell(0.0)
    learner.run(0.1)
    scans = [there.scan(ranges(learner), seconds) for seconds in (0.05, 0.07, 0.09)]
    there.tell(0.12)
    learner.run(0.2)
    expect(len(there.clouds) == 3, f'Three scans came, then the transform for all; {len(there.clouds)} clouds came.')
    there.check_all(scans)


@pytest.mark.weight(2)
@pytest.mark.rules('frame', 'place', 'later', 'time', 'one-cloud')
@about('frame')
def test_two_lasers(learner):
    """Two lasers measure at the same times, with other angles; one of them tells its scans late.

    What belongs to a scan stands in its message: nothing is kept from another one.
    """
    draw = learner.random
    there = laser(learner, speed=(0.5, -0.5, 1.0))
    other = f'robot/{draw.choice(["upper", "lower"])}_laser'
    there.add(other, pose(-0.2, draw.uniform(-0.3, 0.3), 0.3, yaw=draw.uniform(2.0, 3.0)))
    there.tell(0.0)
    learner.run(0.1)
    scans = []
    for hundredths in (5, 9, 7):  # an older one comes after a newer one
        when = round(hundredths / 100 + draw.uniform(0.0, 0.005), 9)
        scans += [
            there.scan(ranges(learner, 3), when, draw.uniform(-2.0, -1.0), draw.uniform(0.1, 0.3)),
            there.scan(ranges(learner, 4), when, draw.uniform(1.0, 2.0), -draw.uniform(0.1, 0.3), frame=other),
        ]
    there.tell(0.12)
    learner.run(0.2)
    count = len(there.clouds)
    expect(count == len(scans), f'Two lasers sent {len(scans)} scans, and {count} clouds came.', 'later')
    there.check_all(scans)
    there.clouds.clear()
    for hundredths in (11, 2):
        scan = there.scan(ranges(learner), hundredths / 100, frame=other)
        with about('one-cloud'):
            cloud = only(there, 'A scan came, the transforms of its time are there')
        there.check(scan, cloud)
        there.clouds.clear()


@pytest.mark.rules('later', 'one-cloud', 'place', 'time')
@about('later')
def test_many_wait(learner):
    """Nine scans wait for one transform, and that again and again: each gets its cloud.

    Keep all that wait, not the last few.
    """
    there = laser(learner, speed=(1.0, -0.5, 2.0))
    there.tell(0.0)
    learner.run(0.15)
    for number in range(9):  # a queue of depth 10 holds what then comes at once
        there.scan(ranges(learner, 2), 0.02 + number / 100)
    there.tell(0.15)
    learner.run(0.2)
    expect(len(there.clouds) == 9, f'Nine scans came, then the transform for all; {len(there.clouds)} clouds came.')
    check_many(there)
