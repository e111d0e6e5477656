"""Visible tests of exercise 3.2, from centimetres to metres."""

import math

import pytest
from sensor_msgs.msg import Range

from helpers.checks.chapter_03.endpoints import check_name, check_nothing_else, check_queue, check_topic, robot
from helpers.checks.chapter_03.ranges import burst, check_burst, check_lost, check_own_topic, check_reading, reading
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.2'), pytest.mark.wiring(type='topics', qos='qos', namespace='topics')]


@pytest.mark.rules('node', 'topics', 'qos', 'one-each', 'at-once', 'distances', 'variance', 'header', 'others', 'inf')
def test_relay(learner):
    """Each Range in centimetres on sonar_cm becomes one Range in metres on sonar, at once.

    Publish in the callback of the subscription.
    """
    random = learner.random
    space = robot(random)
    heard, sensor = learner.listen(f'{space}/sonar', Range), learner.talk(f'{space}/sonar_cm', Range)
    node = learner.start('RangeToMetres', remap={'__ns': space})
    check_name(node, 'range_to_metres', 'node')
    check_topic(learner, 'subscription', space, 'sonar_cm', 'topics')
    check_topic(learner, 'publisher', space, 'sonar', 'topics')
    for kind, topic in (('subscription', 'sonar_cm'), ('publisher', 'sonar')):
        check_queue(learner, kind, f'{space}/{topic}', 10, 'qos')
    slept = learner.slept  # a constructor may
    with about('one-each'):
        learner.run(61.0, step=10.0)
    expect(
        not heard.messages,
        'Your node published before it had received anything: publish neither in the constructor nor in a timer.',
        'one-each',
    )
    echoes = [
        reading(random, variance=4.0),
        reading(random, max_range=math.inf),
        reading(random, range=random.uniform(2e4, 9e4)),
    ]
    silent = random.randint(1, 2)
    echoes.insert(silent, reading(random, range=math.inf))
    for number, message in enumerate(echoes):
        message.header.stamp.sec = 17 * 10**8 + number  # who leaves out older ones breaks another rule than `inf`
        sensor.send(message)
        with about('inf' if number == silent else 'distances'):
            learner.settle()
        check_number(learner, heard, number + 1, 'inf' if number == silent else 'one-each')
        check_reading(heard.messages[number], message)
        expect(
            learner.slept == slept,
            'Your callback sleeps, or waits in a loop, before the message goes out. Publish at once.',
            'at-once',
        )
    sent = burst(random)
    sensor.send(*sent)
    learner.settle()
    count = len(echoes) + len(sent)
    learner.wait_until(lambda: len(heard) >= count, 0.5)  # for a thread of the learner's, which publishes by itself
    check_lost(heard.messages[len(echoes) :], sent)
    check_number(learner, heard, count, 'one-each')
    check_burst(heard.messages[len(echoes) :], sent)
    for _ in range(10):  # more than a hundred in all
        sensor.send(*10 * [sent[0]])
        learner.settle()
        count += 10
        check_number(learner, heard, count, 'one-each')
    learner.run(61.0, step=10.0)
    check_number(learner, heard, count, 'one-each')
    check_nothing_else(learner, {f'{space}/sonar'}, 'one-each')
    check_second(learner, heard, sensor, node)
    check_own_topic(learner, node, heard, sensor)


def check_second(learner, heard, sensor, node):
    """A second relay in the same program publishes nothing by itself either, and both convert each message."""
    count = len(heard)
    with about('one-each'):
        learner.start('RangeToMetres', beside=node)
        learner.settle()
    expect(
        len(heard) == count,
        'A second relay in the same program published before it had received anything: its constructor publishes.',
        'one-each',
    )
    message = reading(learner.random)
    sensor.send(message)
    learner.settle()
    learner.wait_until(lambda: len(heard) >= count + 2, 0.5)
    expect(
        len(heard) == count + 2,
        f'A message went in to two relays in the same program, and {len(heard) - count} came out, expected 2.',
        'one-each',
    )
    for got in heard.messages[count:]:
        check_reading(got, message)


def check_number(learner, heard, wanted, rule):
    learner.wait_until(lambda: len(heard) >= wanted, 0.5)  # for a thread of the learner's, which publishes by itself
    if len(heard) < wanted and rule == 'inf':
        expect(False, 'A message with range=inf went in, and none came out: do not drop messages.', 'inf')
    expect(
        len(heard) > 0 or wanted == 0,
        'A message went in, and none came out at once. Publish in the callback of the subscription, without a timer.',
        'at-once',
    )
    expect(
        len(heard) >= wanted,
        f'{wanted} messages went in, and only {len(heard)} came out by then. Publish each one '
        'in the callback, at once.',
        'one-each',
    )
    expect(
        len(heard) == wanted,
        f'{wanted} messages went in, and {len(heard)} came out. Publish exactly once for each.',
        'one-each',
    )
