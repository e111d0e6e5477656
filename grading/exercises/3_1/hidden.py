"""Hidden tests of exercise 3.1, a beacon."""

import pytest
from std_msgs.msg import String

from helpers.checks.chapter_03.beacons import (
    check_awake,
    check_callbacks_do_not_sleep,
    check_own_publishers,
    check_own_topic,
    check_unheard,
)
from helpers.checks.chapter_03.endpoints import check_name, check_queue, check_topic, robot
from helpers.runner import about, expect, waiting

pytestmark = [pytest.mark.exercise('3.1'), pytest.mark.wiring(type='topic', qos='qos', namespace='topic')]


@pytest.mark.rules('at-once', 'first', 'texts')
def test_first_message(learner):
    """The constructor returns at once, and the first message comes one period after the start, at 0.25 s.

    Let the timer do all the publishing: the constructor only prepares.
    """
    heard = learner.listen('/beacon', String)
    learner.run(learner.random.uniform(1.0, 9.0))
    begin = learner.now / 1e9
    with waiting('at-once'):
        learner.start('Beacon')
    check_awake(learner)
    learner.settle()
    with about('texts'):
        learner.run(0.2)
    expect(
        not heard.messages,
        'A message was published before the first period had passed: publish in the timer only.',
        'first',
    )
    with about('texts'):
        learner.run(0.2)
    expect(
        heard.data != ['alive 2'],
        "The first text that arrives is 'alive 2'. Publish in the timer only: what the "
        'constructor publishes, nobody can hear yet.',
        'first',
    )
    expect(heard.messages, 'The first message has not come 0.4 s after the start.', 'rate')
    expect(
        heard.stamps[0] - begin == pytest.approx(0.25),
        f'The first message came {heard.stamps[0] - begin:g} s after the start, expected 0.25 s.',
        'rate',
    )
    expect(heard.data[0] == 'alive 1', f'The first text is {heard.data[0]!r}, expected {"alive 1"!r}.', 'texts')


@pytest.mark.rules('topic', 'rate')
def test_nobody_listens(learner):
    """A Beacon publishes and counts whether somebody listens or not.

    Publish in each call of the timer. The node needs a name, and no namespace of its own.
    """
    check_unheard(learner, learner.random.randint(7, 20))


@pytest.mark.weight(2)
@pytest.mark.rules('rate', 'texts')
def test_long_run(learner):
    """The rate stays 4 Hz and the texts count on, also over a longer time.

    A timer keeps its rhythm by itself.
    """
    quarters = learner.random.randint(60, 120)
    heard = learner.listen('/beacon', String)
    with waiting('at-once'):
        learner.start('Beacon')
    learner.settle()
    check_callbacks_do_not_sleep(learner)
    with about('texts'):
        learner.run(quarters / 4)
    seconds = quarters / 4 + 0.1
    wanted = [f'alive {number}' for number in range(1, len(heard) + 1)]
    first = next((pair for pair in zip(heard.data, wanted, strict=False) if pair[0] != pair[1]), ('', ''))
    expect(first[0] != 'alive 2' or first[1] != 'alive 1', 'The constructor publishes; only the timer should.', 'first')
    expect(
        heard.data[:2] != ['alive 1', 'alive 1'] or heard.stamps[0] > 0.2 or len(set(heard.data)) == 1,
        'The constructor publishes; only the timer should.',
        'first',
    )
    expect(heard.data == wanted, f'A text is {first[0]!r}, expected {first[1]!r}.', 'texts')
    # On a busy machine somebody may be connected before the constructor has published.
    expect(not heard.stamps or heard.stamps[0] > 0.01, 'The constructor publishes; only the timer should.', 'first')
    expect(
        len(heard) == quarters,
        f'{len(heard)} messages in {seconds:g} s, expected {quarters}: is the period 0.25 s?',
        'rate',
    )
    wanted = [number / 4 for number in range(1, quarters + 1)]
    expect(heard.stamps == pytest.approx(wanted), 'The messages do not come at equal distances of 0.25 s.', 'rate')


@pytest.mark.rules('own-count', 'first')
def test_three_beacons(learner):
    """Three beacons in one program count apart, each from 1.

    Keep the counter in the object (self.…), not in the class or in a global variable.
    """
    heard = learner.listen('/beacon', String)
    with waiting('at-once'):
        first = learner.start('Beacon')
    learner.settle()
    for _ in range(2):
        learner.start('Beacon', beside=first)
    learner.settle()
    check_own_publishers(learner, '/beacon', 3)
    expect(not heard.messages, 'A beacon publishes when it starts: publish in the timer only.', 'first')
    check_callbacks_do_not_sleep(learner)
    with about('texts'):
        learner.run(1.0)
    expect(heard.messages, 'From three beacons nothing came on /beacon in 1.1 s.', 'rate')
    expect(
        len(heard) <= 4 or heard.data != [f'alive {number}' for number in range(1, len(heard) + 1)],
        'Three beacons share one counter: it belongs to the object (self.count), not to the class or the module.',
        'own-count',
    )
    expect(len(set(heard.data)) < len(heard.data) or len(heard) <= 4, 'Several beacons share one counter.', 'own-count')
    wanted = sorted(3 * [f'alive {number}' for number in range(1, 5)])
    if heard.data[:3] == 3 * ['alive 1']:
        expect(
            sorted(heard.data) == wanted,
            f'Three beacons said {heard.data} in 1.1 s, expected each text from 1 to 4 three times.',
            'own-count',
        )


@pytest.mark.rules('node', 'topic', 'qos')
def test_name_and_qos(learner):
    """The node is called beacon, and publishes with the default QoS: reliable, volatile, depth 10.

    The name goes to super().__init__, the number 10 to create_publisher.
    """
    space = robot(learner.random)
    heard = learner.listen(f'{space}/beacon', String)
    with waiting('at-once'):
        beacon = learner.start('Beacon', remap={'__ns': space})
    check_name(beacon, 'beacon', 'node')
    check_topic(learner, 'publisher', space, 'beacon', 'topic')
    check_queue(learner, 'publisher', f'{space}/beacon', 10, 'qos')
    with about('texts'):
        learner.run(0.6)
    check_topic(learner, 'publisher', space, 'beacon', 'topic')  # no callback has made another one
    check_own_topic(learner, beacon, heard)
