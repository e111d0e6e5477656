"""Visible tests of exercise 3.6, a rate and gap monitor."""

import pytest

from helpers.checks.chapter_03 import monitors
from helpers.checks.chapter_03.endpoints import robot
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.6'), pytest.mark.wiring(type='topics', qos='qos', namespace='topics')]
JUST_MORE = 0.5078125  # s, than the default of max_gap; exact as a float and in a stamp


@pytest.mark.rules(
    'node', 'topics', 'any-lidar', 'qos', 'report', 'silent', 'gap', 'at-once', 'limit', 'first', 'old', 'own-state'
)
def test_monitor(learner):
    """A RateMonitor reports every second how many scans have come, and each gap between their stamps at once.

    Count in the callback, report in a timer of 1 s. Compare the stamps of the headers, not the times of arrival.
    """
    random = learner.random
    learner.run(random.randint(3, 9), step=10.0)  # its own time does not begin at 0
    begin = learner.now / 1e9
    max_gap = random.choice([1.25, 2.5, 5.25])
    # A reliable lidar: who takes over what the first publisher offers is found out, too.
    rates, gaps, lidar, node = monitors.start(learner, robot(random), max_gap, qos=10)
    learner.settle()
    slept = learner.slept
    sent = random.randint(2, 5) * [0]
    with about('silent'):
        learner.run(len(sent) + 0.05, step=1.0)
    check_reports(rates, sent, begin)
    stamp = 0.0  # a simulated sensor begins so: it is a stamp like any other
    watched = monitors.ExpectedReports(learner, lidar, gaps, max_gap)
    steps = draw_steps(random, max_gap)
    for count in (5, 10):
        for _ in range(count):
            stamp += steps.pop(0)
            watched.send(stamp)
            stamp = watched.newest
            learner.run(0.05, step=1.0)
        learner.run(1.0 - 0.05 * count, step=1.0)
        watched.end()
        sent.append(count)
        check_reports(rates, sent, begin)
    check_two_at_once(learner, rates, lidar, stamp)
    sent.append(2)
    stamp += 0.25
    watched.newest = stamp
    sent.append(_send_many(watched, random))
    stamp = watched.newest
    learner.run(1.0, step=1.0)
    check_reports(rates, sent, begin)
    silent = random.randint(61, 75)  # reports do not end after a minute
    sent += silent * [0]
    learner.run(silent, step=10.0)
    check_reports(rates, sent, begin)
    stamp += max_gap + 70.5
    watched.send(stamp)  # the first one after the silence
    sent.append(1)
    learner.run(1.0, step=1.0)
    check_reports(rates, sent, begin)
    watched.end()
    expect(
        learner.slept == slept,
        'A callback sleeps, or waits in a loop: what it says comes late, and other scans wait meanwhile.',
        'at-once',
    )
    newest = check_second(learner, rates, gaps, lidar, node, stamp)
    monitors.check_own_topics(learner, node, rates, gaps, lidar, newest, max_gap)
    monitors.check_unheard(learner, node)


@pytest.mark.rules('gap', 'limit', 'report')
def test_limits(learner):
    """A RateMonitor compares whole nanoseconds, and 0 is a limit like any other.

    Subtract stamps as Time objects, or as whole nanoseconds. A report has the number of scans, and no quotient.
    """
    monitors.start(learner, robot(learner.random), 1.25)  # its endpoints are judged
    monitors.check_exact(learner)
    monitors.check_zero(learner)


def _send_many(watched, random) -> int:
    """Some old scans in a row, and then those of a fast lidar, more than a byte can count. Returns how many."""
    stamp, old, pairs = watched.newest, random.randint(4, 6), random.randint(130, 139)
    for _ in range(old):
        watched.send(stamp - watched.max_gap - random.choice([0.25, 7.5, 100.125]))
    for number in range(pairs):
        watched.send_two(stamp + 0.015625 * number + 0.0078125, stamp + 0.015625 * (number + 1))
    return old + 2 * pairs


def draw_steps(random, max_gap):
    """By how many seconds each of 15 stamps is later than the newest one before it; an older scan has a negative step.

    A gap comes after the first stamp. An older scan comes in the same second as the newest, and max_gap follows; two
    gaps are equal; one scan is late, and after it comes one that is no gap from the newest. Another one is very late,
    follows a gap of days directly, and then comes a gap. The last but one has the stamp 0 again.
    """
    late = -max_gap - random.choice([0.25, 0.5, 1.5])
    fresh = [0, max_gap + 0.125, max_gap, -0.125, max_gap]
    very_late = -random.choice([20.5, 75.25, 300.125])
    day = max_gap + random.choice([1_000_000.25, 2_000_000.5])
    steps = [*fresh, *2 * [max_gap + 0.625], 0.125, late, max_gap, day, very_late, max_gap + 0.375]
    return [*steps, -sum(step for step in steps if step > 0), max_gap]


def check_reports(rates, sent, begin):
    """One report for each second since the monitor's start, with the number of scans that were sent in it."""
    expect(
        rates.messages,
        f'Nothing came on scan_rate in the first {len(sent)} s, in which no scan came. A silent sensor calls no '
        "callback: report in a timer, by the node's own clock, and report 0.0, too.",
        'silent',
    )
    expect(
        rates.numbers[0] == 1 and rates.stamps[0] > begin + 0.01,  # it may be heard, on a busy machine
        'A report went out in the constructor. Report in the timer only: the first one comes after 1.0 s.',
        'report',
    )
    came = [round(stamp - begin, 6) for stamp in rates.stamps]
    rule = 'report' if sent[-1] or len(rates) > len(sent) else 'silent'
    expect(
        came == list(range(1, len(sent) + 1)),
        f'Reports came {", ".join(f"{at:g}" for at in came)} s after the start, expected one every 1.0 s of the '
        "node's time, also without scans.",
        rule,
    )
    totals = [sum(sent[: n + 1]) for n in range(len(sent))]
    expect(
        rates.data == sent or rates.data != totals,
        f'{sent} scans came in these seconds and scan_rate says {rates.data}: count from zero again after each report.',
        'report',
    )
    expect(
        (sent[-1], rates.data[-1]) not in ((5, 4), (10, 7)),
        f'Of {sent[-1]} scans in a second some were older than the newest; scan_rate says {rates.data[-1]:g}: they '
        'count, too.',
        'old',
    )
    expect(
        rates.data == sent,
        f'{sent} scans came in these seconds, and scan_rate says {rates.data}.',
        'report' if rates.data[-1] or sent[-1] else 'silent',
    )


def check_two_at_once(learner, rates, lidar, stamp):
    """Two scans that come at one moment, before the node can look, count both."""
    lidar.send(monitors.scan(stamp + 0.125), monitors.scan(stamp + 0.25))
    learner.run(1.0, step=1.0)
    expect(
        rates.data[-1:] != [1.0],
        'Two scans came at one moment, before your node could look, and scan_rate says 1 for this second, expected 2. '
        'The depth of a subscription says how many messages it keeps.',
        'report',
    )


def check_second(learner, rates, gaps, lidar, node, stamp):
    """A second monitor in the same program, with the default limit, between two reports of the first one.

    Returns the newest stamp that both have had.
    """
    begin = learner.now / 1e9
    before, long = len(gaps), learner.random.randint(100, 4000)
    with about('own-state'):
        learner.start('RateMonitor', beside=node)
        learner.settle()
        lidar.send(monitors.scan(stamp + long))
        learner.settle()
        lidar.send(monitors.scan(stamp + 2 * long + 10.0))
        learner.settle()
    came = gaps.data[before:]
    expect(
        came or not before,
        f'A scan came {long} s after the last one, and another one {long + 10} s later; nothing came on scan_gap. A '
        'gap is told, however long it is.',
        'gap',
    )
    expect(
        pytest.approx(stamp + long) not in came or stamp < 1,
        f'For a second monitor the first scan, with the stamp {stamp + long:g}, made a gap of {stamp + long:g} s: '
        'there is nothing before it.',
        'first',
    )
    expect(
        came == pytest.approx([long, long + 10, long + 10]),
        f'A second monitor was started in the same program. Then a scan came {long} s after the last one, and another '
        f'one {long + 10} s later: for the second monitor the first of them has nothing before it. scan_gap says '
        f'{came}, expected {long}, {long + 10}, {long + 10}. The newest stamp belongs to the object (self).',
        'own-state',
    )
    with about('own-state'):
        lidar.send(monitors.scan(stamp + 2 * long + 10.5), monitors.scan(stamp + 2 * long + 10.5 + JUST_MORE))
        learner.run(1.3, step=1.0)
    own = [value for at, value in zip(rates.stamps, rates.data, strict=True) if abs(at - begin - 1.0) < 1e-6]
    others = [
        value for at, value in zip(rates.stamps, rates.data, strict=True) if at > begin and abs(at - begin - 1.0) > 1e-6
    ]
    expect(
        own != [0.0] or others != [4.0],
        'A second monitor heard 4 scans in its first second, and its first report says 0: also the first report says '
        'how many have come.',
        'report',
    )
    expect(
        own == others == [4.0],
        f'Two monitors in the same program heard 4 scans each, and reported {others} and '
        f'{own}. What they count belongs to the object (self).',
        'own-state',
    )
    _check_default(gaps.data[before + 3 :])
    return stamp + 2 * long + 10.5 + JUST_MORE


def _check_default(came: list[float]) -> None:
    """What came on scan_gap for the differences 0.5 and JUST_MORE, of two monitors, of which one has the default."""
    expect(
        came != pytest.approx([JUST_MORE, JUST_MORE]),
        'When a second monitor with another max_gap is made in the same '
        'program, the first one takes over that max_gap.',
        'own-state',
    )
    expect(
        len(came) != 1 or came == pytest.approx([JUST_MORE]) or abs(came[0] - JUST_MORE) > 0.1,
        f'Two stamps that differ by {JUST_MORE} s gave {came} on scan_gap: publish the difference without rounding.',
        'gap',
    )
    expect(
        came == pytest.approx([JUST_MORE]),
        'A second RateMonitor(), without an argument, heard the differences 0.5 and '
        f'{JUST_MORE} s, and {came} came on scan_gap: max_gap is 0.5 then.',
        'limit',
    )
