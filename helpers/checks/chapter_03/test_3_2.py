"""Visible tests of exercise 3.2, from centimetres to metres."""

import pytest
from sensor_msgs.msg import Range

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.2')


def close(value, wanted):
    return value == pytest.approx(wanted, rel=1e-4)


def test_distance_in_metres(learner):
    """A Range with range=150.0 on sonar_cm becomes a Range with range=1.5 on sonar.

    Publish in the callback of the subscription; metres are centimetres divided by 100.
    """
    heard = learner.listen('/sonar', Range)
    sensor = learner.talk('/sonar_cm', Range)
    learner.start('RangeToMetres')
    sensor.send(Range(range=150.0))
    learner.settle()
    expect(len(heard) == 1,
           f'One message went in and {len(heard)} came out at once. Publish once in the callback of the '
           'subscription, without a timer.')
    got = heard.messages[0].range
    expect(not close(got, 15000.0), '150 cm became 15000 m: divide by 100.')
    expect(close(got, 1.5), f'150 cm became {got:g} m, expected 1.5 m.')


def test_limits_in_metres(learner):
    """min_range and max_range become metres, too.

    All three distances of the message have the same unit.
    """
    heard = learner.listen('/sonar', Range)
    sensor = learner.talk('/sonar_cm', Range)
    learner.start('RangeToMetres')
    sensor.send(Range(range=80.0, min_range=2.0, max_range=400.0))
    learner.settle()
    expect(heard.messages, 'Nothing came out on /sonar.')
    message = heard.messages[0]
    expect(message.min_range or message.max_range, 'min_range and max_range are lost: copy all fields.')
    expect(close(message.min_range, 0.02) and close(message.max_range, 4.0),
           f'min_range is {message.min_range:g} and max_range {message.max_range:g}; expected 0.02 and 4. '
           'Convert every distance, not only range.')
