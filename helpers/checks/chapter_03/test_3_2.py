"""Visible tests of exercise 3.2, from centimetres to metres."""

import math

import pytest
from sensor_msgs.msg import Range
from std_msgs.msg import Header

from helpers.checks.chapter_03.endpoints import check_name, check_queue, check_topic, robot
from helpers.checks.chapter_03.ranges import check_reading, reading
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('3.2'), pytest.mark.wiring(type='topics', qos='qos')]


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
    with about('one-each'):
        learner.run(1.0, step=1.0)
    expect(not heard.messages, 'Your node publishes before it has received anything: use no timer.', 'one-each')
    echoes = [
        reading(random, variance=4.0),
        reading(random, max_range=math.inf),
        reading(random, range=random.uniform(600, 900)),
    ]
    silent = random.randint(1, 2)
    echoes.insert(silent, reading(random, range=math.inf))
    for number, message in enumerate(echoes):
        message.header.stamp.sec = 100 + number  # who leaves out older ones breaks another rule than `inf`
        sensor.send(message)
        with about('inf' if number == silent else 'distances'):
            learner.settle()
        check_number(heard, number + 1, 'inf' if number == silent else 'one-each')
        check_reading(heard.messages[number], message)
    count = random.randint(8, 10)
    burst = [reading(random) for _ in range(count)]
    burst[2].range = burst[1].range  # an object that does not move: a message like any other
    burst[3] = reading(random, range=0.0, min_range=0.0, variance=0.0)  # zero is a number like any other
    burst[4] = reading(random, range=random.uniform(0.1, 0.9))  # nearer than min_range: a relay leaves out nothing
    burst[5] = reading(random, range=math.nan)
    burst[6] = reading(random, range=-random.uniform(1, 5))  # nor does it ask what a value means
    burst[7].header = Header()  # as it came, also if there is nothing in it
    sensor.send(*burst)
    learner.settle()
    check_number(heard, len(echoes) + count, 'one-each')
    for got, sent in zip(heard.messages[len(echoes) :], burst, strict=True):
        expect(
            got.header.stamp == sent.header.stamp,
            f'{count} messages came one shortly after the other, and yours came out in another order.',
            'at-once',
        )
        check_reading(got, sent)
    learner.run(2.1, step=1.0)
    check_number(heard, len(echoes) + count, 'one-each')


def check_number(heard, wanted, rule):
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
