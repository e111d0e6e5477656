"""Hidden tests of exercise 3.6, a rate and gap monitor."""

import pytest
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.6')


def scan(seconds):
    message = LaserScan()
    message.header.stamp = Time(nanoseconds=round(seconds * 1e9)).to_msg()
    return message


def monitor(learner, *args, qos=qos_profile_sensor_data, **kwargs):
    rates, gaps = learner.listen('/scan_rate', Float64), learner.listen('/scan_gap', Float64)
    lidar = learner.talk('/scan', LaserScan, qos)
    learner.start('RateMonitor', *args, **kwargs)
    return rates, gaps, lidar


@pytest.mark.weight(2)
def test_changing_rate(learner):
    """Each report counts the scans of its own second, exactly, whatever their rhythm.

    Count in the callback; report and set back in a timer of 1 s on the node's own clock.
    """
    rates, _, lidar = monitor(learner)
    counts = [learner.random.randint(1, 9) for _ in range(5)] + [0]
    stamp = 50.0
    for count in counts:
        learner.run(0.5)
        for _ in range(count):
            stamp += 0.01
            lidar.send(scan(stamp))
            learner.run(0.01)
        learner.run(0.5 - 0.01 * count)
    learner.run(0.1)
    expect(rates.stamps == pytest.approx(range(1, 7)),
           f'The reports came at {rates.stamps} s, expected at 1, 2, … 6 s of the '
           "node's time. Use create_timer, not the clock on the wall.")
    totals = [float(sum(counts[:n + 1])) for n in range(6)]
    expect(rates.data != totals, 'The reports only grow: count from zero again after each report.')
    expect(rates.data == pytest.approx(counts), f'{counts} scans in six seconds gave the reports {rates.data}.')


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
    expect(len(rates) == 5,
           f'{len(rates)} reports came in 5.1 s, expected one every second, also from a silent sensor.')
    expect(rates.data == [0.0, 0.0, 5.0, 0.0, 0.0],
           f'Silence, 5 scans, silence gave {rates.data}, expected [0, 0, 5, 0, 0].')
    expect(not gaps.messages, 'Silence alone makes no message on scan_gap: it takes the next scan to know the gap.')


def test_gaps_from_stamps(learner):
    """A gap is the difference of two stamps, whenever the messages arrive.

    Use header.stamp with its nanoseconds, not the time of arrival.
    """
    _, gaps, lidar = monitor(learner)
    first = learner.random.randint(1000, 2000)
    for stamp, pause in ((0.9, 0.1), (1.3, 3.0), (1.75, 0.1), (2.9, 0.0), (3.1, 2.0), (3.9, 0.1)):
        lidar.send(scan(first + stamp))
        learner.settle()
        learner.run(pause) if pause else None
    expect(gaps.data, 'Two gaps in the stamps gave nothing on /scan_gap.')
    expect(gaps.data == pytest.approx([1.15, 0.8], abs=1e-6),
           f'The gaps are {gaps.data}, expected [1.15, 0.8]. Use the stamps, with nanoseconds, '
           'and not the time of arrival.')
    expect(len(gaps) == 2, 'Each gap is told once.')


def test_gap_at_once(learner):
    """A gap is published at once, not with the next report.

    Publish it in the callback of the subscription.
    """
    _, gaps, lidar = monitor(learner)
    learner.run(0.3)
    lidar.send(scan(5.0), scan(7.0))
    learner.settle()
    expect(gaps.stamps == [0.3], 'The gap was not published at once, when the scan after it came.')


def test_first_scan(learner):
    """The first scan makes no gap, whatever its stamp.

    Begin with None, not with zero or with the start of the node.
    """
    _, gaps, lidar = monitor(learner)
    learner.run(2.0)
    lidar.send(scan(learner.random.uniform(100, 1e6)))
    learner.run(0.2)
    expect(not gaps.messages, f'The first scan made a gap of {gaps.data[:1]} s: there is nothing before it.')


def test_threshold(learner):
    """max_gap is an argument, and a gap of exactly max_gap is none.

    Keep it in self.max_gap and compare with >.
    """
    _, gaps, lidar = monitor(learner, 2.0)
    for stamp in (1.0, 2.5, 4.5, 7.0):
        lidar.send(scan(stamp))
        learner.run(0.1)
    expect(1.5 not in gaps.data, 'RateMonitor(2.0) reports a gap of 1.5 s: max_gap is not used.')
    expect(2.0 not in gaps.data, 'A gap of exactly max_gap is no gap: "more than".')
    expect(gaps.data == [2.5], f'RateMonitor(2.0) with the stamps 1, 2.5, 4.5, 7 reports {gaps.data}, expected [2.5].')


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
    expect(not gaps.messages, f'The stamps 10, 10.4, 9, 10.8, 10.5, 11.2 gave the gaps {gaps.data}, expected none: '
                              'an old scan must not move the newest stamp back.')
    expect(rates.data == [6.0], f'Six scans, two of them late, gave the report {rates.data}, expected [6].')


def test_any_publisher(learner):
    """The monitor hears best-effort and reliable lidars, and reports reliably.

    Request BEST_EFFORT and VOLATILE on scan; offer RELIABLE on the two reports.
    """
    rates, _, lidar = monitor(learner, qos=10)
    learner.run(0.1)
    lidar.send(scan(1.0))
    learner.run(1.0)
    expect(rates.data == [1.0], f'One scan of a reliable lidar gave the report {rates.data}, expected [1].')
    asked = learner.endpoints('/scan').subscriptions
    expect(asked and not asked[0].reliable,
           'Your subscription to scan asks for RELIABLE: a best-effort lidar is not heard.')
    expect(not asked[0].latched, 'Your subscription to scan asks for TRANSIENT_LOCAL: most lidars do not offer it.')


def test_two_monitors(learner):
    """Two monitors, in two namespaces, count apart, and the node is called rate_monitor.

    Relative names, and state in the object.
    """
    lidars, rates = [], []
    for side in ('/front', '/rear'):
        rates.append(learner.listen(f'{side}/scan_rate', Float64))
        lidars.append(learner.talk(f'{side}/scan', LaserScan, qos_profile_sensor_data))
        node = learner.start('RateMonitor', remap={'__ns': side})
        expect(node.name == f'{side}/rate_monitor', f'Your node is called {node.name}, expected {side}/rate_monitor.')
    learner.run(0.5)
    lidars[0].send(scan(1.0), scan(1.1))
    lidars[1].send(scan(2.0))
    learner.run(1.0)
    expect([rate.data for rate in rates] == [[2.0], [1.0]],
           f'Two monitors with 2 and 1 scans report {rates[0].data} and {rates[1].data}.')
