"""Hidden tests of exercise 3.2, from centimetres to metres."""

import math

import pytest
from sensor_msgs.msg import Range

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.2')


def reading(random, **changes):
    message = Range(radiation_type=Range.INFRARED, field_of_view=random.uniform(0.1, 0.9),
                    range=random.uniform(10, 190), variance=random.uniform(1, 9),
                    min_range=random.uniform(1, 5), max_range=random.uniform(200, 500))
    message.header.frame_id = f'sonar_{random.randint(1, 99)}'
    message.header.stamp.sec, message.header.stamp.nanosec = random.randint(1, 999), random.randrange(10**9)
    for field, value in changes.items():
        setattr(message, field, value)
    return message


def relay(learner, *messages):
    heard = learner.listen('/sonar', Range)
    sensor = learner.talk('/sonar_cm', Range)
    learner.start('RangeToMetres')
    for message in messages:
        sensor.send(message)
        learner.settle()
    expect(heard.messages, 'Nothing came out on /sonar at once. Publish in the callback of the subscription.')
    return heard


def close(value, wanted):
    return value == pytest.approx(wanted, rel=1e-4)


def test_header_is_kept(learner):
    """The header goes through unchanged: stamp and frame_id are those of the measurement.

    Copy the header, or publish the message that you have received.
    """
    message = reading(learner.random)
    header = relay(learner, message).messages[0].header
    expect(header.frame_id == message.header.frame_id,
           f'frame_id is {header.frame_id!r}, expected {message.header.frame_id!r}: the header is lost.')
    expect(header.stamp == message.header.stamp,
           'The stamp has changed: it says when the measurement was made, not when it was converted.')


def test_all_distances(learner):
    """range, min_range and max_range are converted with the factor 1/100.

    Three fields have the unit of a distance.
    """
    message = reading(learner.random)
    out = relay(learner, message).messages[0]
    for field in ('range', 'min_range', 'max_range'):
        wanted, got = getattr(message, field) / 100, getattr(out, field)
        expect(close(got, wanted), f'{field} is {got:g}, expected {wanted:g}: convert all three distances.')


def test_variance(learner):
    """The variance is converted with the square of the factor.

    Square centimetres to square metres.
    """
    message = reading(learner.random, variance=4.0)
    got = relay(learner, message).messages[0].variance
    expect(not close(got, 0.04), 'The variance was divided by 100. It is a square: divide by 100 squared.')
    expect(not close(got, 4.0), 'The variance was not converted; it is in square centimetres.')
    expect(close(got, 0.0004), f'The variance 4 cm² became {got:g}, expected 0.0004 m².')


def test_other_fields(learner):
    """field_of_view and radiation_type stay as they are.

    An angle has nothing to do with metres.
    """
    message = reading(learner.random)
    out = relay(learner, message).messages[0]
    expect(close(out.field_of_view, message.field_of_view), 'field_of_view has changed: it is an angle, in radians.')
    expect(out.radiation_type == message.radiation_type, 'radiation_type is lost: copy the fields you do not convert.')


def test_no_echo(learner):
    """The range inf (no echo) stays inf.

    Infinity divided by 100 is infinity: it needs no special case, and no filter.
    """
    heard = relay(learner, reading(learner.random, range=math.inf), reading(learner.random, range=50.0))
    expect(len(heard) == 2, f'Two messages, one of them inf, gave {len(heard)}: do not drop messages.')
    expect(heard.messages[0].range == math.inf, f'inf became {heard.messages[0].range:g}.')


@pytest.mark.weight(2)
def test_one_out_for_each_in(learner):
    """Each message in gives one message out, in order, and time alone gives none.

    No timer, no buffer: publish once in the callback.
    """
    heard = learner.listen('/sonar', Range)
    sensor = learner.talk('/sonar_cm', Range)
    learner.start('RangeToMetres')
    learner.run(1.1)
    expect(not heard.messages, 'Your node publishes before it has received anything: use no timer.')
    values = [float(learner.random.randint(10, 300)) for _ in range(8)]
    for value in values:
        sensor.send(reading(learner.random, range=value))
    learner.settle()
    learner.run(2.1)
    expect(len(heard) == len(values),
           f'{len(values)} messages in gave {len(heard)} out. Publish exactly once for each, '
           'in the callback: a timer loses or repeats some.')
    expect([m.range for m in heard.messages] == pytest.approx([v / 100 for v in values], rel=1e-4),
           'The messages came out in another order or with other values.')


def test_namespace(learner):
    """In a namespace both topics move with the node, and the node is called range_to_metres.

    Relative names have no leading slash.
    """
    heard = learner.listen('/arm/sonar', Range)
    sensor = learner.talk('/arm/sonar_cm', Range)
    node = learner.start('RangeToMetres', remap={'__ns': '/arm'})
    expect(node.name == '/arm/range_to_metres', f'Your node is called {node.name}, expected /arm/range_to_metres.')
    sensor.send(reading(learner.random))
    learner.settle()
    expect(len(heard) == 1, 'In the namespace /arm nothing goes through: use topic names without a leading slash.')
