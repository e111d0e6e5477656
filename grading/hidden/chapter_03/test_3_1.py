"""Hidden tests of exercise 3.1, a beacon."""

import pytest
from std_msgs.msg import String

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.1')


def test_first_message(learner):
    """The first message comes one period after the start, at 0.25 s.

    Let the timer do all the publishing: the constructor only prepares.
    """
    heard = learner.listen('/beacon', String)
    learner.start('Beacon')
    learner.run(0.2)
    expect(not heard.messages, 'A message was published before the first period had passed: publish in the timer only.')
    learner.run(0.2)
    expect(heard.data != ['alive 2'], "The first text that arrives is 'alive 2'. Publish in the timer only: what the "
                                      'constructor publishes, nobody can hear yet.')
    expect(heard.stamps == [0.25], f'In the first 0.4 s messages came at {heard.stamps} s, expected one, at 0.25 s.')


@pytest.mark.weight(2)
def test_long_run(learner):
    """The rate stays 4 Hz and the texts count on, also over a longer time.

    A timer keeps its rhythm by itself.
    """
    quarters = learner.random.randint(60, 120)
    heard = learner.listen('/beacon', String)
    learner.start('Beacon')
    learner.run(quarters / 4 + 0.1)
    seconds = quarters / 4 + 0.1
    expect(len(heard) == quarters,
           f'{len(heard)} messages in {seconds:g} s, expected {quarters}: is the period 0.25 s?')
    wanted = [f'alive {number}' for number in range(1, quarters + 1)]
    first = next((pair for pair in zip(heard.data, wanted, strict=False) if pair[0] != pair[1]), ('', ''))
    expect(heard.data == wanted, f'A text is {first[0]!r}, expected {first[1]!r}.')
    wanted = [number / 4 for number in range(1, quarters + 1)]
    expect(heard.stamps == pytest.approx(wanted), 'The messages do not come at equal distances of 0.25 s.')


def test_two_beacons(learner):
    """Two beacons in one program count apart, each from 1.

    Keep the counter in the object (self.…), not in the class or in a global variable.
    """
    heard = learner.listen('/beacon', String)
    first = learner.start('Beacon')
    learner.start('Beacon', beside=first)
    learner.run(1.1)
    expect(heard.data != [f'alive {number}' for number in range(1, len(heard) + 1)],
           'Two beacons share one counter: it belongs to the object (self.count), not to the class or the module.')
    wanted = sorted(2 * [f'alive {number}' for number in range(1, 5)])
    expect(sorted(heard.data) == wanted,
           f'Two beacons said {heard.data} in 1.1 s, expected each text from 1 to 4 twice.')


def test_namespace(learner):
    """In a namespace the beacon's topic moves with it.

    A relative topic name has no leading slash.
    """
    robot = f'/robot{learner.random.randint(2, 99)}'
    heard = learner.listen(f'{robot}/beacon', String)
    learner.start('Beacon', remap={'__ns': robot})
    learner.run(1.1)
    absolute = learner.endpoints('/beacon').publishers
    expect(not absolute, f'In the namespace {robot} your node still publishes on /beacon: leave out the leading slash.')
    expect(len(heard) == 4, f'In the namespace {robot} {len(heard)} messages came on {robot}/beacon, expected 4.')


def test_name_and_qos(learner):
    """The node is called beacon, and publishes with the default QoS: reliable, volatile.

    The name goes to super().__init__, the number 10 to create_publisher.
    """
    node = learner.start('Beacon')
    expect(node.name == '/beacon', f'Your node is called {node.name}, expected /beacon.')
    publishers = learner.endpoints('/beacon').publishers
    expect(len(publishers) == 1, f'Your node has {len(publishers)} publishers on /beacon, expected 1.')
    expect(publishers[0].type == 'std_msgs/msg/String',
           f'The type is {publishers[0].type}, expected std_msgs/msg/String.')
    expect(publishers[0].reliable, 'Your publisher is BEST_EFFORT; depth 10 alone gives RELIABLE.')
