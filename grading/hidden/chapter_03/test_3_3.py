"""Hidden tests of exercise 3.3, heartbeat."""

import pytest
from std_msgs.msg import Bool, Empty, Int32

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.3')


def test_exact_times(learner):
    """LED messages come at 0.25, 0.5, 0.75 … s and uptimes at 1, 2, 3 … s.

    Two timers, and no waiting in a callback.
    """
    led, uptime = learner.listen('/led', Bool), learner.listen('/uptime', Int32)
    learner.start('Heartbeat')
    learner.run(6.1)
    expect(len(set(led.stamps)) == len(led),
           'Several LED messages come at the same moment. Does a callback loop or sleep?')
    expect(led.stamps == pytest.approx([n / 4 for n in range(1, 25)]),
           f'The first LED messages came at {led.stamps[:4]} s, expected 0.25, 0.5, 0.75, 1.0 s.')
    expect(uptime.stamps == pytest.approx(range(1, 7)), f'The uptimes came at {uptime.stamps} s, expected 1, 2, … 6 s.')


@pytest.mark.weight(2)
def test_reset_keeps_the_rhythm(learner):
    """A reset sets only the counter: the timers go on as before.

    No timer is stopped, made anew or reset.
    """
    uptime = learner.listen('/uptime', Int32)
    button = learner.talk('/reset', Empty)
    learner.start('Heartbeat')
    before = learner.random.randint(2, 5) + learner.random.choice([0.3, 0.4, 0.6, 0.7])
    learner.run(before)
    count = len(uptime)
    button.send(Empty())
    learner.settle()
    expect(len(uptime) == count, 'The reset itself published an uptime: only the timer publishes.')
    learner.run(3.0)
    fraction = {round(stamp % 1, 3) for stamp in uptime.stamps}
    expect(fraction <= {0.0, 1.0},
           f'After a reset at {before:g} s uptimes came at {uptime.stamps[count:]} s: the reset must '
           'not restart the timer.')
    expect(uptime.data[count:] != [0, 1, 2], 'The first uptime after a reset is 0, expected 1.')
    expect(uptime.data[count:] == [1, 2, 3], f'After a reset uptime says {uptime.data[count:]}, expected [1, 2, 3].')


def test_reset_leaves_led(learner):
    """A reset does not touch the LED.

    LED and uptime are two states: reset one of them.
    """
    led = learner.listen('/led', Bool)
    button = learner.talk('/reset', Empty)
    learner.start('Heartbeat')
    learner.run(1.3)  # after five messages the LED is on
    button.send(Empty())
    learner.run(2.0)
    expect(led.data == [n % 2 == 0 for n in range(len(led))],
           'The LED missed a change at the reset: do not reset its state.')
    expect(len(led) == 13, f'With a reset, {len(led)} LED messages came in 3.3 s, expected 13: its timer goes on.')


def test_every_reset(learner):
    """Every reset works, also the second and one before the first second.

    The callback sets the counter to 0 each time.
    """
    uptime = learner.listen('/uptime', Int32)
    button = learner.talk('/reset', Empty)
    learner.start('Heartbeat')
    button.send(Empty())
    learner.run(2.5)
    button.send(Empty(), Empty())
    learner.run(1.0)
    button.send(Empty())
    learner.run(2.0)
    expect(uptime.data == [1, 2, 1, 1, 2],
           f'With resets at 0, 2.5 and 3.5 s uptime says {uptime.data}, expected [1, 2, 1, 1, 2].')


def test_two_heartbeats(learner):
    """Two heartbeats in one program do not disturb each other.

    State belongs to the object: self.…, set in __init__.
    """
    led, uptime = learner.listen('/led', Bool), learner.listen('/uptime', Int32)
    first = learner.start('Heartbeat')
    learner.start('Heartbeat', beside=first)
    learner.run(2.1)
    expect(sorted(uptime.data) == [1, 1, 2, 2],
           f'Two heartbeats say the uptimes {uptime.data} in 2.1 s, expected 1, 1, 2, 2: '
           'they share state. It belongs to the object (self).')
    expect(led.data.count(True) == 8 and led.data[:2] == [True, True],
           'Two heartbeats share the state of the LED. It belongs to the object (self).')


def test_namespace(learner):
    """In a namespace all three topics move with the node, and the node is called heartbeat.

    Relative names have no leading slash.
    """
    uptime = learner.listen('/left/uptime', Int32)
    led = learner.listen('/left/led', Bool)
    button = learner.talk('/left/reset', Empty)
    node = learner.start('Heartbeat', remap={'__ns': '/left'})
    expect(node.name == '/left/heartbeat', f'Your node is called {node.name}, expected /left/heartbeat.')
    learner.run(1.5)
    button.send(Empty())
    learner.run(1.0)
    expect(led.messages and uptime.data == [1, 1],
           'In the namespace /left not all topics work: use names without a leading slash.')
