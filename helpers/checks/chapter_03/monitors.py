"""Scans with stamps, and the reports of a RateMonitor: for exercise 3.6."""

import pytest
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.checks.chapter_03.endpoints import check_name, check_queue, check_topic
from helpers.runner import about, expect
from helpers.runner.peers import SECOND

HARDLY = 400  # ns
# How a stamp (ns) may be made a float
AS_FLOATS = (
    lambda stamp: stamp / 1e9,
    lambda stamp: stamp * 1e-9,
    lambda stamp: stamp // SECOND + stamp % SECOND / 1e9,
    lambda stamp: stamp // SECOND + stamp % SECOND * 1e-9,
)


def scan(seconds: float) -> LaserScan:
    """A scan with this stamp."""
    return _scan(round(seconds * 1e9))


def _scan(nanoseconds: int) -> LaserScan:
    message = LaserScan(scan_time=0.0625, time_increment=0.0001)  # what a gap does not depend on
    message.header.stamp = Time(nanoseconds=nanoseconds).to_msg()
    message.header.frame_id = f'lidar_{nanoseconds % 7}'  # of several lidars, each scan is one like any other
    return message


def check_exact(learner, **start) -> None:
    """Of a third monitor: stamps of today that differ by exactly its max_gap make no gap; hardly more makes one.

    The seconds of the first two stamps as floats differ by more, as they have not digits enough.
    """
    random = learner.random
    exact = [ms / 1000 for ms in range(50, 450) if ms * 1_000_000 * 1e-9 == ms / 1000 == ms * 1_000_000 / 1e9]
    early, max_gap = next(
        (early, max_gap)
        for early, max_gap in ((_today(random), random.choice(exact)) for _ in range(10_000))
        if all(way(early + round(max_gap * SECOND)) - way(early) > max_gap for way in AS_FLOATS)
    )
    gaps = learner.listen('/exact/scan_gap', Float64)
    lidar = learner.talk('/exact/scan', LaserScan, qos_profile_sensor_data, strict=False)
    learner.start('RateMonitor', max_gap, remap={'__ns': '/exact'}, **start)
    for stamp in (early, early + round(max_gap * SECOND)):
        with about('limit'):
            learner.settle()
        lidar.send(_scan(stamp))
    with about('limit'):
        learner.settle()
    expect(
        not gaps.messages,
        f'With max_gap {max_gap:g} s, two stamps of today, {early} ns and exactly max_gap later, gave {gaps.data} on '
        'scan_gap. A float has too few digits for them: subtract whole nanoseconds, or Time objects, then divide.',
        'limit',
    )
    more = round(max_gap * SECOND) + HARDLY
    lidar.send(_scan(early + round(max_gap * SECOND) + more))
    with about('limit'):
        learner.settle()
    expect(
        len(gaps) != 1 or gaps.data == pytest.approx([more / SECOND]),
        f'With max_gap {max_gap:g} s, a stamp {more} ns after the newest gave {gaps.data} on scan_gap, expected '
        f'{more / SECOND:.9g}: the difference of the two stamps in seconds, without rounding.',
        'gap',
    )
    expect(
        gaps.data == pytest.approx([more / SECOND]),
        f'With max_gap {max_gap:g} s, a stamp {more} ns after the newest gave {gaps.data} on scan_gap. It is '
        'more than max_gap, if only by nanoseconds: compare without rounding.',
        'limit',
    )


def check_zero(learner, **start) -> None:
    """Of a monitor with the limit 0: each later stamp makes a gap. A late report has the count, and no quotient."""
    rates, gaps = (learner.listen(f'/zero/{topic}', Float64) for topic in ('scan_rate', 'scan_gap'))
    lidar = learner.talk('/zero/scan', LaserScan, qos_profile_sensor_data, strict=False)
    learner.start('RateMonitor', 0.0, remap={'__ns': '/zero'}, **start)
    stamp, step = learner.random.randint(5, 90), learner.random.choice([0.015625, 0.03125, 0.0625])
    for seconds in (stamp, stamp, stamp + step):
        with about('limit'):
            learner.settle()
        lidar.send(scan(seconds))
    with about('limit'):
        learner.settle()
    expect(
        gaps.data == pytest.approx([step]),
        f'RateMonitor(0.0) heard the stamps {stamp}, {stamp} and {stamp + step:g} s, and {gaps.data} came on scan_gap, '
        f'expected {[step]}: 0.0 is a max_gap like any other. (`max_gap or 0.5` is 0.5 then.)',
        'limit',
    )
    with about('report'):
        learner.run(1.05, step=1.0)
        lidar.send(scan(stamp + step), scan(stamp + step))
        learner.jump(2.0)
        learner.run(1.1, step=1.0)
    expect(
        rates.data[:1] != [0.0],
        'Three scans came in the first second of a monitor, and its first report says 0: also the first report says '
        'how many have come.',
        'report',
    )
    counts = [count for count in rates.data if count]
    expect(
        counts[:1] != [2.0],
        f'Three scans came in a second, with the stamps {stamp}, {stamp} and {stamp + step:g} s; the report says 2. '
        'Each scan counts, also with a stamp that was there before.',
        'report',
    )
    late = f'{counts[1]:g}' if len(counts) > 1 else 'nothing'
    expect(
        counts in ([], [3.0], [3.0, 2.0]),  # none at all is the subject of other tests
        f'Three scans came in a second, two after it, and then the next report was called a second late, as on a busy '
        f'machine. The two reports say {counts[0]:g} and {late}, expected 3 and 2: how many scans '
        'have come since the last report. Do not divide by the time.'
        if counts
        else '',
        'report',
    )


def _today(random) -> int:
    """A stamp (ns) as lidars have it."""
    return random.randint(1_700_000_000 * SECOND, 1_800_000_000 * SECOND)


def start(learner, space: str, *args, qos=qos_profile_sensor_data, **kwargs):
    """A monitor in the namespace: what it reports, the gaps, the lidar's publisher, and the node.

    :raises ExpectationFailed: node, topics or QoS are not as specified.
    """
    rates, gaps = learner.listen(f'{space}/scan_rate', Float64), learner.listen(f'{space}/scan_gap', Float64)
    lidar = learner.talk(f'{space}/scan', LaserScan, qos, strict=False)
    node = learner.start('RateMonitor', *args, remap={'__ns': space} if space else None, **kwargs)
    check_name(node, 'rate_monitor', 'node')
    check_topic(learner, 'subscription', space, 'scan', 'topics')
    there = learner.endpoints(f'{space}/scan').subscriptions[0]
    expect(
        there.type == 'sensor_msgs/msg/LaserScan',
        f'Your subscription to scan has the type {there.type}, expected sensor_msgs/msg/LaserScan.',
        'topics',
    )
    expect(
        not there.reliable,
        'Your subscription to scan requests RELIABLE: a best-effort lidar is not heard. Ask for less.',
        'any-lidar',
    )
    expect(
        not there.latched,
        'Your subscription to scan requests TRANSIENT_LOCAL, which most lidars do not offer.',
        'any-lidar',
    )
    limits = ', '.join(f'{policy} {value}' for policy, value in there.limits.items())
    expect(
        not limits,
        f'Your subscription to scan asks for the policy {limits}: a lidar that does not offer this is not heard. Ask '
        'for less.',
        'any-lidar',
    )
    for topic in ('scan_rate', 'scan_gap'):
        check_topic(learner, 'publisher', space, topic, 'topics')
        check_queue(learner, 'publisher', f'{space}/{topic}', 10, 'qos')
    return rates, gaps, lidar, node


class ExpectedReports:
    """What a monitor with this `max_gap` must say, from the scans that are sent to it."""

    def __init__(self, learner, lidar, gaps, max_gap: float):
        self.learner, self.lidar, self.gaps, self.max_gap = learner, lidar, gaps, max_gap
        self.newest: float | None = None
        self.last_gap: float | None = None  # the newest stamp when the last gap came, or the first stamp
        self.known = len(gaps)  # messages on scan_gap that are judged
        self.after_old = False  # the scan before was older than the newest one
        self.missing: list[str] = []  # gaps of which nothing was told when the scan came

    def send(self, stamp: float) -> None:
        """One scan; what comes on scan_gap at once is judged."""
        self._judge_silence()
        self.lidar.send(scan(stamp))
        with about('gap'):
            self.learner.settle()
        got, self.known = self.gaps.data[self.known :], len(self.gaps)
        self._judge(stamp, got)
        self.after_old = self.newest is not None and stamp < self.newest
        if self.newest is None or stamp > self.newest + self.max_gap:
            self.last_gap = stamp
        self.newest = stamp if self.newest is None else max(self.newest, stamp)

    def send_two(self, first: float, second: float) -> None:
        """Two scans that come at one moment, and none of which makes a gap."""
        self.lidar.send(scan(first))
        self.newest = first
        self.send(second)

    def end(self) -> None:
        """After a report: nothing more has come on scan_gap."""
        late, self.known = self.gaps.data[self.known :], len(self.gaps)
        for said in self.missing:
            expect(not late, f'{said} The gap is told only later: publish it when the scan comes.', 'at-once')
            expect(False, said, 'gap')
        expect(not late, f'{late} came on scan_gap without a scan: silence alone makes no gap.', 'gap')

    def _judge_silence(self) -> None:
        """Before a scan: nothing has come on scan_gap that is not judged, but for a gap that is told late."""
        if not self.missing:
            self.end()

    def _judge(self, stamp: float, got: list[float]) -> None:
        if self.newest is None:
            expect(
                not got,
                f'The first scan, with the stamp {stamp:g}, made a gap of {got[:1]} s: there is nothing before it.',
                'first',
            )
            return
        gap = round(stamp - self.newest, 9)
        said = f'With max_gap {self.max_gap:g} s, the newest stamp {self.newest:g} and then {stamp:g}'
        if gap < 0:
            expect(
                not got,
                f'{said}, {got} came on scan_gap: a scan that is older than the newest one makes no gap.',
                'old',
            )
        elif gap <= self.max_gap:
            right = got and abs(got[0] - gap) < 1e-6
            why = 'Only a difference of more than max_gap is a gap.'
            if self.after_old:
                why = 'The scan between them was older; it must not move the newest stamp back.'
            elif not right and got and abs(got[0] - (stamp - self.last_gap)) < 1e-6:
                why = (
                    f'This is how long ago the stamp {self.last_gap:g} was, that of the last gap. Each scan that is '
                    'not older is the newest one from then on, also without a gap.'
                )
            elif not right and got and got[0] > gap:
                why = (
                    f'This is more than the difference to the newest stamp, {gap:g} s. Each scan that is not older is '
                    'the newest one from then on, also after a gap.'
                )
            expect(
                not got,
                f'{said}, {got} came on scan_gap. {why}',
                'old' if self.after_old else 'limit' if right else 'gap',
            )
        elif not got:
            self.missing.append(f'{said}, nothing came on scan_gap when the second scan came.')
        else:
            expect(
                abs(got[0] - gap) < 1e-6,
                f'{said}, scan_gap says {got[0]:g}, expected {gap:g}: the difference of '
                f'the stamps, {"without rounding" if abs(got[0] - gap) < 0.51 else "with their nanoseconds"}.',
                'old' if self.after_old else 'gap',
            )
            expect(len(got) == 1, f'{said}, {len(got)} messages came on scan_gap: each gap is told once.', 'gap')


def check_own_topics(learner, node, rates, gaps, lidar, newest: float, max_gap: float) -> None:
    """A monitor reports on its own topics when another one has been made in another namespace.

    :param newest, max_gap: the newest stamp that it has had, and its limit.
    """
    theirs = [learner.listen(f'{OTHER}/{topic}', Float64) for topic in ('scan_rate', 'scan_gap')]
    with about('own-state'):
        learner.start('RateMonitor', max_gap, beside=node, remap={'__ns': OTHER})
        learner.settle()
        for heard in (rates, gaps, *theirs):
            heard.clear()
        lidar.send(scan(newest + 1.5 * max_gap))
        learner.settle()
    story = f'A scan came to the first one {1.5 * max_gap:g} s after the newest stamp'
    check_own('RateMonitor', story, len(gaps), len(theirs[1]), 'scan_gap', 'publishers', 'own-state')
    with about('own-state'):
        learner.run(1.1, step=1.0)
    story = 'They ran for more than a second'
    check_own('RateMonitor', story, len(rates), len(theirs[0]), 'scan_rate', 'publishers', 'own-state')


def check_unheard(learner, node=None) -> None:
    """A monitor counts, and begins anew each second, also while nobody hears its reports.

    :param node: a monitor in whose program this one is made.
    """
    space, early = '/unheard', learner.random.randint(4, 6)
    lidar = learner.talk(f'{space}/scan', LaserScan, qos_profile_sensor_data, strict=False)

    def send(count: int, seconds: float) -> None:
        """So many scans, and then a pause."""
        for _ in range(count):
            lidar.send(scan(1.0))
            learner.settle()
        learner.run(seconds, step=1.0)

    with about('report'):
        learner.start('RateMonitor', beside=node, remap={'__ns': space})
        learner.settle()
        send(early, 2.2)  # the reports are due after 1, 2 and 3 s
        send(2, 0.3)
        rates = learner.listen(f'{space}/scan_rate', Float64)
        learner.settle()
        send(1, 0.7)
    first = rates.data[0] if rates.messages else 3.0  # who reports nothing is told so elsewhere
    expect(
        first == 3.0,
        f'{early} scans came in the first second of a monitor, none in the next one, and 3 in the third, in the middle '
        f'of which somebody began to listen. The first report that came then says {first:g}, expected 3: count, '
        'report, and begin from zero again, also if nobody listens.',
        'report',
    )
