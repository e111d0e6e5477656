"""Hidden tests of exercise 3.2, from centimetres to metres."""

import math

import pytest
from sensor_msgs.msg import Range
from std_msgs.msg import Header

from helpers.checks.chapter_03.endpoints import check_name, check_nothing_else, check_queue, check_topic
from helpers.checks.chapter_03.ranges import burst, check_burst, check_own_topic, check_reading, reading
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.2'), pytest.mark.wiring(type='topics', qos='qos', namespace='topics')]


def relay(learner, *messages):
    heard = learner.listen('/sonar', Range)
    sensor = learner.talk('/sonar_cm', Range)
    learner.start('RangeToMetres')
    check_topic(learner, 'subscription', '', 'sonar_cm', 'topics')
    check_topic(learner, 'publisher', '', 'sonar', 'topics')
    learner.run(learner.random.uniform(1.0, 9.0))  # the clock is at another time than 0
    for message in messages:
        sensor.send(message)
        with about('inf' if math.isinf(message.range) else 'distances'):
            learner.settle()
    arrive(learner, heard, len(messages))
    return heard


def arrive(learner, heard, count):
    """Give a thread of the learner's, which publishes by itself, the time for it."""
    learner.wait_until(lambda: len(heard) >= count, 0.5)


@pytest.mark.weight(2)
@pytest.mark.rules('distances', 'variance', 'header', 'others', 'one-each')
def test_readings(learner):
    """Every field has the right unit, or is as it was, for near and far objects.

    Distances have the factor 1/100, the variance its square. Publish the message that you have received.
    """
    random = learner.random
    messages = [
        reading(random),
        reading(random, range=random.uniform(0.5, 3.0), variance=random.uniform(20, 90)),
        reading(random, range=random.uniform(500, 5000), radiation_type=Range.ULTRASOUND),
        reading(random, variance=0.0, min_range=0.0),
        reading(random, range=math.nan),
        reading(random, range=400.0, max_range=400.0),
        reading(random, range=-math.inf),
        reading(random, range=random.uniform(0.1, 0.9), min_range=0.0625, max_range=0.9375),
        reading(random, range=-random.uniform(1, 5), header=Header()),  # a relay does not ask what it means
    ]
    random.shuffle(messages)
    heard = relay(learner, *messages)
    expect(
        heard.messages, 'Nothing came out on /sonar at once. Publish in the callback of the subscription.', 'at-once'
    )
    expect(
        len(heard) == len(messages),
        f'{len(messages)} messages in gave {len(heard)} out. One of them has the range nan, another one a negative '
        'range: a relay leaves out nothing.',
        'one-each',
    )
    for got, sent in zip(heard.messages, messages, strict=True):
        check_reading(got, sent)


@pytest.mark.rules('inf')
def test_no_echo(learner):
    """The range inf (no echo) stays inf, and so does an endless max_range.

    Infinity divided by 100 is infinity: it needs no special case, and no filter.
    """
    random = learner.random
    messages = [reading(random, range=math.inf), reading(random, range=math.inf, max_range=math.inf)]
    heard = relay(learner, *messages)
    expect(len(heard) >= 2, f'Two messages with range=inf gave {len(heard)}: do not drop messages.', 'inf')
    expect(len(heard) == 2, f'Two messages gave {len(heard)}.', 'one-each')
    for got, sent in zip(heard.messages, messages, strict=True):
        check_reading(got, sent)


@pytest.mark.weight(2)
@pytest.mark.rules('one-each', 'at-once')
def test_one_out_for_each_in(learner):
    """Each message in gives one message out, in order, and time alone gives none.

    No timer, no buffer: publish once in the callback.
    """
    heard = learner.listen('/sonar', Range)
    sensor = learner.talk('/sonar_cm', Range)
    learner.start('RangeToMetres')
    check_topic(learner, 'subscription', '', 'sonar_cm', 'topics')
    check_topic(learner, 'publisher', '', 'sonar', 'topics')
    learner.run(61.0, step=10.0)
    expect(
        not heard.messages,
        'Your node published before it had received anything: publish neither in the constructor nor in a timer.',
        'one-each',
    )
    sent, slept = burst(learner.random), learner.slept  # a constructor may sleep
    sensor.send(*sent)
    learner.settle()
    arrive(learner, heard, len(sent))
    expect(heard.messages, 'Nothing came out at once.', 'at-once')
    expect(learner.slept == slept, 'Your callback sleeps, or waits in a loop. Publish at once.', 'at-once')
    learner.run(61.0, step=10.0)
    expect(
        len(heard) == len(sent),
        f'{len(sent)} messages in gave {len(heard)} out. Publish exactly once for each, '
        'in the callback: a timer loses or repeats some.',
        'one-each',
    )
    check_burst(heard.messages, sent)
    check_nothing_else(learner, {'/sonar'}, 'one-each')


@pytest.mark.rules('node', 'topics', 'qos')
def test_namespace(learner):
    """In a namespace both topics move with the node, and the node is called range_to_metres.

    Relative names have no leading slash.
    """
    space = f'/arm{learner.random.randint(2, 9)}'
    heard, sensor = learner.listen(f'{space}/sonar', Range), learner.talk(f'{space}/sonar_cm', Range)
    node = learner.start('RangeToMetres', remap={'__ns': space})
    check_name(node, 'range_to_metres', 'node')
    for kind, topic in (('subscription', 'sonar_cm'), ('publisher', 'sonar')):
        check_topic(learner, kind, space, topic, 'topics')
        check_queue(learner, kind, f'{space}/{topic}', 10, 'qos')
    check_own_topic(learner, node, heard, sensor)


@pytest.mark.rules('one-each')
def test_two_relays(learner):
    """Two relays in one program answer one message each.

    State, if there is any, belongs to the object.
    """
    heard = learner.listen('/sonar', Range)
    sensor = learner.talk('/sonar_cm', Range)
    first = learner.start('RangeToMetres')
    check_topic(learner, 'subscription', '', 'sonar_cm', 'topics')
    check_topic(learner, 'publisher', '', 'sonar', 'topics')
    learner.start('RangeToMetres', beside=first)
    sensor.send(reading(learner.random))
    learner.settle()
    arrive(learner, heard, 2)
    expect(heard.messages, 'Nothing came out at once.', 'at-once')
    expect(len(heard) == 2, f'One message to two relays gave {len(heard)} out, expected 2.', 'one-each')
