"""Visible tests of exercise 3.3, heartbeat."""

import pytest
from std_msgs.msg import Bool, Empty, Int32

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.3')


def test_led(learner):
    """The LED changes every 0.25 s: True, False, True, …

    One timer with the period 0.25; its callback flips the value and publishes it.
    """
    led = learner.listen('/led', Bool)
    learner.start('Heartbeat')
    learner.run(3.1)
    expect(len(led) == 12, f'{len(led)} messages came on /led in 3.1 s; every 0.25 s gives 12.')
    expect(led.data[0], 'The first LED message is False; it begins with True.')
    expect(led.data == [True, False] * 6, 'The LED must change with every message: True, False, True, …')


def test_uptime(learner):
    """uptime counts whole seconds: 1, 2, 3, …

    A second timer with the period 1.0. Do not sleep and do not derive it from the LED timer's calls by rounding.
    """
    uptime = learner.listen('/uptime', Int32)
    learner.start('Heartbeat')
    learner.run(3.1)
    expect(uptime.data, 'Nothing came on /uptime in 3.1 s. Two jobs need two timers.')
    expect(uptime.data == [1, 2, 3], f'/uptime says {uptime.data} in 3.1 s; expected [1, 2, 3].')


def test_reset(learner):
    """After a reset, the next uptime is 1.

    The callback of the subscription to reset sets the counter to 0, and nothing else.
    """
    uptime = learner.listen('/uptime', Int32)
    button = learner.talk('/reset', Empty)
    learner.start('Heartbeat')
    learner.run(3.1)
    button.send(Empty())
    learner.run(2.0)
    expect(uptime.data != [1, 2, 3, 4, 5], 'A message on /reset changes nothing: uptime counts on.')
    expect(uptime.data == [1, 2, 3, 1, 2],
           f'/uptime says {uptime.data} with a reset after 3.1 s; expected [1, 2, 3, 1, 2].')
