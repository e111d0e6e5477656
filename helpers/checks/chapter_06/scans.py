"""What the tests of exercise 6.4 show the learner's node: a robot that drives and turns, with a laser on it."""

import collections
import itertools
import math

import numpy as np
from rclpy.time import Time
from sensor_msgs.msg import LaserScan, PointCloud2
from sensor_msgs_py.point_cloud2 import read_points_list

from helpers.checks.chapter_06.frame_comparisons import apart, explain, same, words
from helpers.runner import about, expect
from helpers.runner.frames import pose
from helpers.runner.peers import SECOND


class Laser:
    """A laser in `frame`, at `mount` (its matrix in base_link). The robot moves evenly: tf2's interpolation is exact.

    `speed`: what x, y and yaw change in a second (metres, radians). All times are seconds since `begin`: the clock
    itself is far from 0.
    """

    def __init__(self, learner, frame='laser', mount=None, start=(2.0, 1.0, math.pi / 2), speed=(0.0, 0.0, 0.0)):
        self.learner, self.frame = learner, frame
        self.mount = pose(z=0.5) if mount is None else mount
        self._start, self._speed = np.array(start), np.array(speed)
        self.begin = learner.random.randint(1000, 1900)
        learner.now = self.begin * SECOND
        self._mounts = {frame: self.mount}
        self._tf = learner.tf_broadcaster()
        self._scans = learner.talk('/scan', LaserScan)
        self._last = itertools.cycle([0, -1, None])  # see _angle_max
        self._sent: list[LaserScan] = []  # all scans so far, to say whose points a wrong cloud has
        self._told: set[float] = set()  # the times of all transforms so far
        self.clouds = learner.listen('/points', PointCloud2)
        self.node = learner.start('ScanToMap')
        self._tf.fix('base_link', frame, self.mount)

    @property
    def now(self) -> float:
        """The time of the clock."""
        return self.learner.now / SECOND - self.begin

    def add(self, frame: str, mount: np.ndarray) -> None:
        """Another laser on the same robot."""
        self._mounts[frame] = mount
        self._tf.fix('base_link', frame, mount)

    def where(self, seconds: float, frame: str | None = None) -> np.ndarray:
        """The matrix of a laser in map, or that of base_link."""
        x, y, yaw = self._start + seconds * self._speed
        return pose(x, y, 0.0, yaw=yaw) @ self._mounts.get(frame or self.frame, np.eye(4))

    def tell(self, seconds: float) -> None:
        """The robot says where it is at that time."""
        self._told.add(seconds)
        x, y, yaw = self._start + seconds * self._speed
        self._tf.send('map', 'base_link', pose(x, y, 0.0, yaw=yaw), self.begin + seconds)

    def scan(self, ranges, seconds: float, first=-0.6, step=0.3, limits=(0.125, 12.0), frame=None) -> LaserScan:
        """Send a scan that was measured at that time.

        `first` and `step` in radians; `limits`, in metres, are numbers that a float32 holds exactly.
        """
        scan = self._scan(ranges, seconds, first, step, limits, frame)
        self._scans.send(scan)
        self.learner.settle()
        return scan

    def scan_together(self, ranges: list[list[float]], seconds: list[float]) -> list[LaserScan]:
        """Send several scans before the node can look: the distances of each, in m, and when it was measured, in s."""
        messages = [self._scan(*scan) for scan in zip(ranges, seconds, strict=True)]
        self._scans.send(*messages)
        self.learner.settle()
        return messages

    def _scan(self, ranges, seconds: float, first=-0.6, step=0.3, limits=(0.125, 12.0), frame=None) -> LaserScan:
        scan = LaserScan(
            angle_min=first,
            angle_max=self._angle_max(first, step, len(ranges)),
            angle_increment=step,
            time_increment=0.02,  # of what a scan says of time, only the header counts
            scan_time=0.16,
            range_min=limits[0],
            range_max=limits[1],
            ranges=list(map(float, ranges)),
        )
        scan.header.frame_id = frame or self.frame
        scan.header.stamp = Time(nanoseconds=round((self.begin + seconds) * SECOND)).to_msg()
        self._sent.append(scan)
        return scan

    def _angle_max(self, first: float, step: float, count: int) -> float:
        """What drivers say: one step after the last direction, the last direction itself, or nothing (0.0)."""
        more = next(self._last)
        return 0.0 if more is None else first + step * (count + more)

    def hits(self, scan: LaserScan) -> np.ndarray:
        """The hits of a scan in the frame of the laser, Nx3, in metres."""
        ranges = np.array(scan.ranges)
        angles = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
        with np.errstate(invalid='ignore'):
            good = (ranges >= scan.range_min) & (ranges <= scan.range_max)
        x, y = ranges * np.cos(angles), ranges * np.sin(angles)
        return np.column_stack([x, y, np.zeros_like(x)])[good]

    def check_all(self, scans: list[LaserScan], others: dict | None = None) -> None:
        """Fail with the reason unless each of the scans has its cloud among as many as came. `others`: see `check`."""

        def place(message, count: int) -> tuple[int, int]:
            return _nanoseconds(message), count

        scans = sorted(scans, key=lambda scan: place(scan, len(scan.ranges)))
        clouds = sorted(self.clouds.messages, key=lambda cloud: place(cloud, len(points(cloud))))
        stamps = [[_nanoseconds(message) for message in messages] for messages in (scans, clouds)]
        measured, said = [[f'{number / SECOND:.2f}' for number in numbers] for numbers in stamps]
        many = [stamp for stamp, count in collections.Counter(stamps[1]).items() if count > stamps[0].count(stamp) > 0]
        expect(
            not many,
            f'Scans of the times {", ".join(measured)} s came together, and their clouds have the stamps '
            f'{", ".join(said)} s: the cloud of one scan went out in the place of others. Keep what belongs to a scan '
            'in a variable of its own callback until the transform comes; an attribute of self has only the newest.',
            'later',
        )
        for scan, cloud in zip(scans, clouds, strict=True):
            self.check(scan, cloud, others)

    def check(self, scan: LaserScan, cloud: PointCloud2, others: dict | None = None) -> None:
        """Fail with the reason if the cloud is not this scan's. `others`: wrong times, and their reasons."""
        exact = [_nanoseconds(message) for message in (scan, cloud)]
        stamps = [nanoseconds / SECOND for nanoseconds in exact]
        expect(
            cloud.header.frame_id == 'map',
            f'The cloud has the frame_id `{cloud.header.frame_id}`, expected `map`.',
            'place',
        )
        self._check_points(scan, points(cloud), stamps[0] - self.begin, others or {})
        expect(
            exact[1] == exact[0],
            f'The scan is of time {stamps[0]:.9f} s, its cloud has the stamp '
            f'{stamps[1]:.9f} s. A stamp says when it was measured, and does not '
            'change.',
            'stamp',
        )

    def _check_points(self, scan: LaserScan, found: np.ndarray, seconds: float, others: dict) -> None:
        """Fail with the reason if these are not the points in map of a scan that was measured at this time."""
        frame, hits = scan.header.frame_id, self.hits(scan)
        mine = same(found, moved(hits, self.where(seconds, frame)), 1e-3)
        other = None if mine else self._whose(scan, found)
        expect(
            other is None,
            f'The cloud of a scan with {len(hits)} hits, measured in `{frame}`, has the points of another scan, with '
            f'{0 if other is None else len(self.hits(other))} hits. Keep the points of a scan in a variable of its own '
            'callback until its transform comes; an attribute of self has only those of the scan that came last.',
            'later',
        )
        expect(
            len(found) == len(hits),
            f'A scan with {len(hits)} hits from {scan.range_min:g} to {scan.range_max:g} m '
            f'gave a cloud of {len(found)} points. The distances were {_few(scan.ranges)}. '
            + ('Both limits are hits.' if len(found) < len(hits) else 'What is beyond a limit is left out.'),
            'range',
        )
        there = self.where(seconds, frame)
        wanted = moved(hits, there)
        odd = [number for number in range(len(hits)) if not same(found[number], wanted[number], 1e-3)]
        number = (*odd, 0)[0]
        is_at, must = apart(found[number], wanted[number])
        told = (
            f'Hit {number + 1} of the scan, {words(hits[number])} in `{frame}`, is at {is_at} in the cloud, expected '
            f'{must}.'
        )
        mixed = same(sorted(found.tolist()), sorted(wanted.tolist()), 1e-3) and not same(found, wanted, 1e-3)
        expect(
            not mixed,
            f'{told} The points are right, and their order is not that of the scan, which begins at angle_min.',
            'order',
        )
        whole = {math.floor(seconds): 'This is the transform of the whole second: count the nanoseconds, too.'}
        for other, reason in (whole | others).items():
            expect(
                same(found, wanted, 1e-3) or not same(found, moved(hits, self.where(other, frame)), 1e-3),
                f'{told} {reason}',
                'time',
            )
        for other in {*self._mounts, 'base_link'} - {frame}:
            expect(
                same(found, wanted, 1e-3) or not same(found, moved(hits, self.where(seconds, other)), 1e-3),
                f'{told} This is the transform of `{other}`, not of the frame in the header of the scan.',
                'frame',
            )
        for other in sorted(self._told | {self._seconds(sent) for sent in self._sent}):
            expect(
                same(found, wanted, 1e-3) or not same(found, moved(hits, self.where(other, frame)), 1e-3),
                f'{told} This is the transform of the time {self.begin + other:.2f} s, and the scan is of '
                f'{self.begin + seconds:.2f} s. Ask for the transform anew for each scan.',
                'time',
            )
        self._check_place(scan, found, there, told)

    def _seconds(self, scan: LaserScan) -> float:
        return _nanoseconds(scan) / SECOND - self.begin

    def _whose(self, scan: LaserScan, found: np.ndarray) -> LaserScan | None:
        """The scan with other hits whose points these are, where the laser was for this one or for that one."""
        here = self.where(self._seconds(scan), scan.header.frame_id)
        for sent in self._sent if len(found) else []:
            hits = self.hits(sent)
            places = here, self.where(self._seconds(sent), sent.header.frame_id)
            if not same(hits, self.hits(scan)) and any(same(found, moved(hits, at), 1e-3) for at in places):
                return sent
        return None

    def _check_place(self, scan: LaserScan, found: np.ndarray, there: np.ndarray, told: str) -> None:
        """Fail with `told` and the reason if these are not the hits of a scan of a laser whose matrix is `there`."""
        hits = self.hits(scan)
        wanted = moved(hits, there)
        degrees = moved(self.hits(_in_degrees(scan)), there)
        spread = moved(self.hits(_spread(scan)), there)
        counted = moved(self.hits(_hits_only(scan)), there)
        reasons = [
            (np.eye(4), 'It is still in the frame of the laser: only the name of the frame has changed.'),
            (np.linalg.inv(there), 'The transform goes from map to the laser: target and source are swapped.'),
        ]
        explain(
            same(found, wanted, 1e-3),
            told,
            *[(same(found, moved(hits, wrong), 1e-3), reason) for wrong, reason in reasons],
            (same(found, degrees, 1e-3), 'The angles of a scan are in radians already.'),
            (
                same(found, spread, 1e-3),
                'The directions are spread from angle_min to angle_max. Each is one angle_increment farther than the '
                'one before.',
            ),
            (
                same(found, counted, 1e-3),
                'The directions are counted from hit to hit. Each distance has its own, also if it is no hit.',
            ),
            rule='place',
        )


def check_topics(there: Laser) -> None:
    """Fail unless the node has its two topics, with the depth 10."""
    for topic, kind in (('/scan', 'subscription'), ('/points', 'publisher')):
        expect(getattr(there.learner.endpoints(topic), f'{kind}s'), f'Your node has no {kind} on {topic}.', 'topics')
        depths = there.learner.depths(kind, topic)
        expect(depths == [10], f'Your {kind} on {topic} has the depth {depths[0]}, expected 10.', 'topics')


def check_no_hits(there: Laser, seconds: float) -> None:
    """Fail unless a scan of this time, whose transforms are there, gives a cloud although it sees nothing."""
    for distances, what in (([math.inf, math.nan, 0.0], 'a hit'), ([], 'any distance (ranges is empty)')):
        there.clouds.clear()
        with about('one-cloud'):
            there.scan(distances, seconds)
            there.learner.run(0.1)
        found = [len(points(cloud)) for cloud in there.clouds.messages]
        expect(
            found == [0],
            f'A scan without {what} gave {len(found)} clouds, expected one without points, for each scan.',
            'one-cloud',
        )


def check_zero(there: Laser, seconds: float) -> None:
    """Fail unless a distance of 0.0 is a hit if range_min is 0; the transforms of this time are there."""
    there.clouds.clear()
    distances = there.learner.random.sample([0.0, 0.0, 2.0, 3.0], 4)
    there.scan(distances, seconds, limits=(0.0, 12.0))
    there.learner.run(0.1)
    found = [len(points(cloud)) for cloud in there.clouds.messages]
    expect(
        found,
        'Two scans came, one after the other, with the same time in their headers, and the second one gave no cloud: '
        'one cloud for each scan.',
        'one-cloud',
    )
    expect(
        found == [4],
        f'A scan with range_min 0.0 and the distances {distances} gave clouds with {found} points, expected one with '
        '4: what is equal to range_min is a hit, also if it is 0.0, which counts as false in Python, and each hit is a '
        'point, also where there is one already.',
        'range',
    )


def check_long_wait(there: Laser) -> None:
    """Fail unless a scan gets its cloud although its transform comes most of a second after it."""
    draw, begin = there.learner.random, there.now
    there.clouds.clear()
    there.tell(begin)
    scan = there.scan([draw.uniform(0.5, 9.0) for _ in range(3)], begin + 0.05)
    silence = round(draw.uniform(0.7, 0.9), 2)
    there.learner.run(silence, step=1.0)
    expect(not there.clouds.messages, 'A cloud came before the transforms of its time were known.', 'time')
    there.tell(begin + 0.1)
    there.learner.run(0.1)
    expect(
        len(there.clouds) == 1,
        f'The transform of a scan came {silence} s after it, and {len(there.clouds)} clouds, expected one. The cloud '
        'is published when the transform comes: do not give up so soon.',
        'later',
    )
    there.check(scan, there.clouds.messages[0], {begin + 0.1: 'This is the transform of another time.'})


def check_standing(there: Laser) -> None:
    """Fail unless each of two long scans with the same distances gives a cloud, as if the robot stands still."""
    draw, begin = there.learner.random, there.now
    there.clouds.clear()
    there.tell(begin)
    there.tell(begin + 0.1)
    there.learner.settle()
    beams = draw.randint(600, 1100)  # as of a laser that looks all around
    distances = [draw.uniform(0.5, 9.0) for _ in range(beams)]
    for seconds in (0.03, 0.06):
        scan = there.scan(distances, begin + seconds, first=0.0, step=math.tau / beams)
    there.learner.run(0.1)
    count = len(there.clouds)
    expect(
        count == 2,
        f'Two scans came with the same distances, as those of a robot that stands still, and gave {count} clouds: one '
        'cloud for each scan.',
        'one-cloud',
    )
    there.check(scan, there.clouds.messages[-1])


def check_many(there: Laser) -> None:
    """Fail unless a node that has run for long still gives a cloud for each scan."""
    draw, before = there.learner.random, 0
    for _ in range(8):
        there.clouds.clear()
        begin, count = there.now, draw.randint(8, 10)  # a queue of depth 10 holds what comes at once
        there.tell(begin)
        moments = [begin + (number + 1) / 100 for number in range(count)]
        scans = there.scan_together([[draw.uniform(0.5, 9.0) for _ in range(2)] for _ in moments], moments)
        there.learner.run(0.12)
        there.tell(begin + 0.12)
        there.learner.run(0.1)
        clouds = len(there.clouds)
        expect(
            clouds == count,
            f'After more than {before} scans {count} more came, then the transforms for all of them, and '
            f'{clouds} clouds: one cloud for each scan, however many there were before.',
            'one-cloud',
        )
        there.check_all(scans)
        before += count


def points(cloud: PointCloud2) -> np.ndarray:
    """The points of a cloud, Nx3; fails if it cannot be read."""
    try:
        return np.array([tuple(point) for point in read_points_list(cloud, ('x', 'y', 'z'))], float).reshape(-1, 3)
    except Exception as error:  # noqa: BLE001 - the cloud is the learner's: whatever is wrong in it
        expect(
            False,
            f'The cloud cannot be read ({type(error).__name__}: {error}). Make it with create_cloud_xyz32.',
            'place',
        )


def _nanoseconds(message) -> int:
    """The stamp of a scan or of a cloud."""
    return Time.from_msg(message.header.stamp).nanoseconds


def _few(distances) -> str:
    """The distances as a list, or the first of them."""
    shown = ', '.join(f'{distance:.4g}' for distance in distances[:16])
    return f'[{shown}]' if len(distances) <= 16 else f'{shown} and {len(distances) - 16} more'


def moved(hits: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """Points (Nx3) through a 4x4 matrix."""
    return hits @ matrix[:3, :3].T + matrix[:3, 3]


def _spread(scan: LaserScan) -> LaserScan:
    """The scan with directions that go from angle_min to angle_max in equal steps."""
    step = (scan.angle_max - scan.angle_min) / max(1, len(scan.ranges) - 1)
    return LaserScan(
        angle_min=scan.angle_min,
        angle_increment=step,
        range_min=scan.range_min,
        range_max=scan.range_max,
        ranges=scan.ranges,
    )


def _hits_only(scan: LaserScan) -> LaserScan:
    """The scan as if there had been nothing but its hits."""
    low, high = scan.range_min, scan.range_max
    return LaserScan(
        angle_min=scan.angle_min,
        angle_increment=scan.angle_increment,
        range_min=low,
        range_max=high,
        ranges=[distance for distance in scan.ranges if low <= distance <= high],
    )


def _in_degrees(scan: LaserScan) -> LaserScan:
    return LaserScan(
        angle_min=math.radians(scan.angle_min),
        angle_increment=math.radians(scan.angle_increment),
        range_min=scan.range_min,
        range_max=scan.range_max,
        ranges=scan.ranges,
    )
