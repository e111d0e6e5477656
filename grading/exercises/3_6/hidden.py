"""Hidden tests of exercise 3.6, a rate and gap monitor."""

import pytest

from helpers.checks.chapter_03 import monitors
from helpers.checks.chapter_03.monitors import scan
from helpers.checks.chapter_03.test_3_6 import check_two_at_once
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.6'), pytest.mark.wiring(type='topics', qos='qos', namespace='topics')]


def monitor(learner, *args, space='', **kwargs):
    rates, gaps, lidar, _ = monitors.start(learner, space, *args, **kwargs)
    return rates, gaps, lidar


@pytest.mark.weight(2)
@pytest.mark.rules('report')
def test_changing_rate(learner):
    """Each report counts the scans of its own second, exactly, whatever their rhythm.

    Count in the callback; report and set back in a timer of 1 s on the node's own clock.
    """
    rates, _, lidar = monitor(learner)
    counts = [*(learner.random.randint(1, 9) for _ in range(4)), 2 * learner.random.randint(130, 140), 0]
    stamp = 50.0
    for count in counts:
        learner.run(0.5)
        at_once = 2 if count > 9 else 1  # a fast lidar: more than a byte can count
        for _ in range(count // at_once):
            for _ in range(at_once):
                stamp += 0.002
                lidar.send(scan(stamp))
            learner.run(0.003)
        learner.run(0.5 - 0.003 * (count // at_once))
    learner.run(0.1)
    expect(
        rates.stamps == pytest.approx(range(1, 7)),
        f'The reports came at {rates.stamps} s, expected at 1, 2, … 6 s of the '
        "node's time. Use create_timer, not the clock on the wall.",
        'report' if set(counts[: len(rates)]) - {0} and len(rates) != sum(map(bool, counts)) else 'silent',
    )
    totals = [float(sum(counts[: n + 1])) for n in range(6)]
    expect(rates.data != totals, 'The reports only grow: count from zero again after each report.', 'report')
    expect(
        rates.data == pytest.approx(counts), f'{counts} scans in six seconds gave the reports {rates.data}.', 'report'
    )
    check_two_at_once(learner, rates, lidar, stamp)
    monitors.check_unheard(learner)


@pytest.mark.rules('silent')
def test_silent_sensor(learner):
    """A sensor that has died is reported as 0.0, and one that has not begun, too.

    The report belongs into a timer.
    """
    rates, gaps, lidar = monitor(learner)
    learner.run(2.2)
    for number in range(5):
        lidar.send(scan(10 + number / 10))
        learner.run(0.1)
    learner.run(2.4)
    expect(
        len(rates) == 5,
        f'{len(rates)} reports came in 5.1 s, expected one every second, also from a silent sensor.',
        'silent',
    )
    expect(
        rates.data == [0.0, 0.0, 5.0, 0.0, 0.0],
        f'Silence, 5 scans, silence gave {rates.data}, expected [0, 0, 5, 0, 0].',
        'silent' if rates.data[:3] == [0.0, 0.0, 5.0] and not any(rates.data[3:]) else 'report',
    )
    minutes = learner.random.randint(1, 3)
    learner.run(60 * minutes, step=10.0)
    expect(
        len(rates) == 5 + 60 * minutes,
        f'A sensor was silent for {minutes} min, and {len(rates) - 5} reports came in this time, expected '
        f'{60 * minutes}.',
        'silent',
    )
    expect(
        not gaps.messages, 'Silence alone makes no message on scan_gap: it takes the next scan to know the gap.', 'gap'
    )


@pytest.mark.rules('gap', 'limit')
def test_gaps_from_stamps(learner):
    """A gap is the difference of two stamps, whenever the messages arrive.

    Use header.stamp with its nanoseconds, not the time of arrival.
    """
    _, gaps, lidar = monitor(learner)
    first, long = learner.random.randint(1000, 2000), learner.random.randint(1_000_000, 4_000_000)
    for stamp, pause in (
        (0.9, 0.1),
        (1.3, 3.0),
        (1.75, 0.1),
        (2.55, 0.0),
        (2.75, 2.0),
        (3.9, 0.1),
        (5.05, 0.0),
        (5.05 + long, 0.1),
    ):
        lidar.send(scan(first + stamp))
        learner.settle()
        learner.run(pause) if pause else None
    expect(gaps.data, 'Four gaps in the stamps gave nothing on /scan_gap.', 'gap')
    expect(
        gaps.data != pytest.approx([1.15, 1.15, long], abs=1e-6),
        'RateMonitor() told the gap of 1.15 s, and not the one of 0.8 s: max_gap is 0.5 if nobody gives it.',
        'limit',
    )
    expect(
        gaps.data == pytest.approx([0.8, 1.15, 1.15, long], abs=1e-6),
        f'The gaps are {gaps.data}, expected [0.8, 1.15, 1.15, {long}]. Use the stamps, with nanoseconds, '
        'and not the time of arrival.',
        'gap',
    )


@pytest.mark.rules('at-once', 'gap')
def test_gap_at_once(learner):
    """A gap is published at once, not with the next report.

    Publish it in the callback of the subscription.
    """
    _, gaps, lidar = monitor(learner)
    with about('silent'):
        learner.run(0.3)
    lidar.send(scan(0.0), scan(2.0))  # a simulated sensor begins so
    learner.settle()
    at_once = gaps.stamps
    learner.run(2.0)
    expect(gaps.messages, 'The stamps 0 and 2 gave nothing on scan_gap.', 'gap')
    expect(
        at_once == [0.3] or gaps.stamps[0] == 0.3,
        'The gap was not published at once, when the scan after it came.',
        'at-once',
    )
    expect(len(gaps) == 1, f'One gap was told {len(gaps)} times.', 'gap')


@pytest.mark.rules('first')
def test_first_scan(learner):
    """The first scan makes no gap, whatever its stamp.

    Begin with None, not with zero or with the start of the node.
    """
    _, gaps, lidar = monitor(learner)
    with about('silent'):
        learner.run(2.0)
    lidar.send(scan(learner.random.uniform(100, 1e6)))
    learner.run(0.2)
    expect(not gaps.messages, f'The first scan made a gap of {gaps.data[:1]} s: there is nothing before it.', 'first')


@pytest.mark.rules('limit', 'report')
def test_threshold(learner):
    """max_gap is an argument, and a gap of exactly max_gap is none.

    Keep it in self.max_gap and compare with >.
    """
    _, gaps, lidar = monitor(learner, max_gap=2.0)
    for stamp in (1.0, 2.5, 4.5, 7.0):
        lidar.send(scan(stamp))
        learner.run(0.1)
    expect(1.5 not in gaps.data, 'RateMonitor(2.0) reports a gap of 1.5 s: max_gap is not used.', 'limit')
    expect(2.0 not in gaps.data, 'A gap of exactly max_gap is no gap: "more than".', 'limit')
    expect(
        gaps.data == [2.5],
        f'RateMonitor(2.0) with the stamps 1, 2.5, 4.5, 7 reports {gaps.data}, expected [2.5].',
        'gap',
    )
    monitors.check_exact(learner)
    monitors.check_zero(learner)


@pytest.mark.rules('old')
def test_old_scan(learner):
    """A scan that is older than the newest one is counted, but changes nothing else.

    Move the newest stamp forward only.
    """
    rates, gaps, lidar = monitor(learner)
    learner.run(0.2)
    for stamp in (10.0, 10.4, 9.0, 10.8, 10.5, 11.2):
        lidar.send(scan(stamp))
        learner.run(0.1)
    learner.run(0.3)
    expect(
        not gaps.messages,
        f'The stamps 10, 10.4, 9, 10.8, 10.5, 11.2 gave the gaps {gaps.data}, expected none: '
        'an old scan must not move the newest stamp back.',
        'old',
    )
    expect(
        rates.data == [6.0],
        f'Six scans, two of them late, gave the report {rates.data}, expected [6].',
        'old' if rates.data == [4.0] else 'report',
    )
    lidar.send(scan(13.0))
    learner.settle()
    came = gaps.data
    expect(came == pytest.approx([1.8]), f'The stamps 11.2 and 13 gave {came} on scan_gap, expected [1.8].', 'gap')
    lidar.send(*[scan(stamp) for stamp in learner.random.sample([12.0, 11.0, 9.5, 0.5], 4)], scan(13.25))
    learner.settle()
    expect(
        gaps.data == came,
        f'After the stamp 13 came four older ones, then 13.25, and {gaps.data[len(came) :]} came on scan_gap: an old '
        'scan makes no gap, and changes nothing.',
        'old',
    )
    later = 13.25 + learner.random.choice([7_000, 90_000, 200_000])
    lidar.send(scan(later), scan(learner.random.choice([0.0, 12.5])), scan(later + 0.25))
    learner.settle()
    told = gaps.data[len(came) + 1 :]
    expect(
        not told,
        f'After the stamp {later:g} came one that was hours older, then {later + 0.25:g}, and {told} came on scan_gap: '
        'an old scan makes no gap, however old it is, and it must not move the newest stamp back.',
        'old',
    )


@pytest.mark.rules('any-lidar', 'qos')
def test_any_publisher(learner):
    """The monitor hears best-effort and reliable lidars, and reports reliably.

    Request BEST_EFFORT and VOLATILE on scan; offer RELIABLE on the two reports.
    """
    rates, _, lidar = monitor(learner, qos=10)
    learner.run(0.1)
    lidar.send(scan(1.0))
    learner.run(1.0)
    expect(rates.data == [1.0], f'One scan of a reliable lidar gave the report {rates.data}, expected [1].', 'report')


@pytest.mark.rules('own-state', 'node', 'topics')
def test_two_monitors(learner):
    """Two monitors in one program count apart, and keep their own newest stamp and limit.

    Relative names, and state in the object.
    """
    space = f'/base{learner.random.randint(2, 9)}'
    rates, gaps, lidar, first = monitors.start(learner, space, 3.0)
    with about('silent'):
        learner.run(0.5)
    lidar.send(scan(10.0), scan(12.0))
    learner.settle()
    expect(not gaps.messages, f'With max_gap 3 s, a difference of 2 s gave {gaps.data}.', 'limit')
    learner.start('RateMonitor', max_gap=1.0, beside=first)
    learner.settle()
    lidar.send(scan(13.0), scan(15.0), scan(20.0))
    with about('own-state'):
        learner.run(1.2)
    expect(
        gaps.data == [2.0, 5.0, 5.0],
        f'Two monitors with max_gap 3 and 1 s heard differences of 1, 2 and 5 s, and {gaps.data} came '
        'on scan_gap, expected [2, 5, 5].',
        'own-state',
    )
    expect(
        rates.data[:2] == [5.0, 3.0], f'Two monitors heard 5 and 3 scans, and reported {rates.data[:2]}.', 'own-state'
    )
    monitors.check_own_topics(learner, first, rates, gaps, lidar, 20.0, 3.0)


@pytest.mark.rules('limit')
def test_default(learner):
    """Without an argument max_gap is 0.5 s.

    RateMonitor(max_gap=0.5): exactly so much is no gap, a little more is one.
    """
    _, gaps, lidar = monitor(learner)
    begin, more = learner.random.randint(5, 90), 0.5 + learner.random.choice([1, 2]) / 256
    lidar.send(scan(begin), scan(begin + 0.5), scan(begin + 0.5 + more))
    learner.settle()
    expect(
        gaps.data == pytest.approx([more]),
        f'A RateMonitor() heard the differences 0.5 and {more:g} s, and {gaps.data} came on scan_gap: '
        'max_gap is 0.5 then.',
        'limit',
    )
