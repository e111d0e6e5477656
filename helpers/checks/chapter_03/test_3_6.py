"""Visible tests of exercise 3.6, a rate and gap monitor."""

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


def test_rate(learner):
    """A best-effort lidar at 10 Hz gives scan_rate 10.0 every second.

    Subscribe so that best effort is enough; count in the callback, report in a timer.
    """
    rates = learner.listen('/scan_rate', Float64)
    lidar = learner.talk('/scan', LaserScan, qos_profile_sensor_data)
    learner.start('RateMonitor')
    learner.run(0.05)
    for number in range(30):
        lidar.send(scan(100 + number / 10))
        learner.run(0.1)
    expect(rates.data, 'Nothing came on /scan_rate in 3 s. The report belongs into a timer of 1 s.')
    expect(rates.data != [10.0, 20.0, 30.0], 'The rate grows, 10, 20, 30: count from zero again after each report.')
    expect(rates.data == [10.0, 10.0, 10.0], f'A lidar at 10 Hz gave the reports {rates.data}, expected [10, 10, 10].')


def test_silence(learner):
    """A silent sensor is reported as 0.0, every second.

    A callback that is never called cannot report: use a timer.
    """
    rates = learner.listen('/scan_rate', Float64)
    learner.start('RateMonitor')
    learner.run(3.5)
    expect(rates.data, 'Without scans there is no report. A dead sensor must not look like a quiet one.')
    expect(rates.data == [0.0, 0.0, 0.0], f'3.5 s without scans gave the reports {rates.data}, expected [0, 0, 0].')


def test_gap(learner):
    """The stamps 3.2 and 4.7 in a row make one message 1.5 on scan_gap.

    Subtract the stamps of the headers; keep the newest one.
    """
    gaps = learner.listen('/scan_gap', Float64)
    lidar = learner.talk('/scan', LaserScan, qos_profile_sensor_data)
    learner.start('RateMonitor')
    for stamp in (3.0, 3.2, 4.7, 4.9):
        lidar.send(scan(stamp))
        learner.run(0.1)
    expect(gaps.data, 'The stamps 3.2 and 4.7 follow each other, and nothing came on /scan_gap. '
                      'Compare the stamps, not the times of arrival.')
    expect(gaps.data == pytest.approx([1.5]),
           f'The stamps 3.0, 3.2, 4.7, 4.9 gave the gaps {gaps.data}, expected [1.5].')
