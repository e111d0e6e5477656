"""Hidden tests of exercise 3.3, heartbeat."""

import pytest
from std_msgs.msg import Bool, Empty, Int32

from helpers.checks.chapter_03.endpoints import check_name, check_queue, check_topic
from helpers.checks.chapter_03.heartbeats import check_unheard
from helpers.checks.chapter_03.test_3_3 import press
from helpers.runner import expect, waiting

pytestmark = [pytest.mark.exercise('3.3'), pytest.mark.wiring(type='topics', qos='qos', namespace='topics')]


@pytest.mark.rules('led', 'led-rate', 'uptime', 'uptime-rate', 'reset', 'no-wait')
def test_exact_times(learner):
    """LED messages come at 0.25, 0.5, 0.75 … s and uptimes at 1, 2, 3 … s, also over a longer time.

    Two timers, and no waiting in a callback.
    """
    led, uptime = learner.listen('/led', Bool), learner.listen('/uptime', Int32)
    button = learner.talk('/reset', Empty)
    seconds = learner.random.randint(61, 75)  # a minute is no limit
    with waiting('no-wait'):
        learner.start('Heartbeat')
    learner.settle()
    with waiting('no-wait'):
        learner.run(2.1, step=0.5)
    expect(not learner.slept, 'The program sleeps, or waits in a loop; its timers do the waiting.', 'no-wait')
    with waiting('no-wait'):
        learner.run(seconds - 2.0, step=0.5)
    expect(not learner.slept, 'The program sleeps, or waits in a loop; its timers do the waiting.', 'no-wait')
    expect(
        led.stamps == pytest.approx([n / 4 for n in range(1, 4 * seconds + 1)]),
        f'The first LED messages came at {led.stamps[:4]} s, expected 0.25, 0.5, 0.75, 1.0 s.',
        'led-rate',
    )
    expect(
        uptime.stamps == pytest.approx(range(1, seconds + 1)),
        f'The uptimes came at {uptime.stamps} s, expected 1, 2, … {seconds} s.',
        'uptime-rate',
    )
    expect(
        led.data == 2 * seconds * [True, False], f'The LED says {led.data[:6]} …, expected True, False, True …', 'led'
    )
    expect(uptime.data == list(range(1, seconds + 1)), f'The uptimes are {uptime.data}, expected 1, 2, 3 …', 'uptime')
    press(learner, button, 1)
    learner.run(2.0, step=0.5)
    expect(
        uptime.data[seconds:] == [1, 2] or len(uptime) != seconds + 2,  # other tests look at the rhythm
        f'A reset came after the uptime {seconds}, and then the uptimes {uptime.data[seconds:]}, expected [1, 2].',
        'reset',
    )
    check_unheard(learner)


@pytest.mark.weight(2)
@pytest.mark.rules('reset', 'reset-only')
def test_reset_keeps_the_rhythm(learner):
    """A reset sets only the counter: the timers go on as before.

    No timer is stopped, made anew or reset.
    """
    uptime = learner.listen('/uptime', Int32)
    button = learner.talk('/reset', Empty)
    with waiting('no-wait'):
        learner.start('Heartbeat')
    learner.settle()
    before = learner.random.randint(2, 5) + learner.random.choice([0.3, 0.4, 0.6, 0.7])
    with waiting('no-wait'):
        learner.run(before)
    count = len(uptime)
    button.send(Empty())
    learner.settle()
    expect(len(uptime) == count, 'The reset itself published an uptime: only the timer publishes.', 'reset-only')
    expect(not learner.slept, 'A callback sleeps; the timers do the waiting.', 'no-wait')
    learner.run(3.0)
    later = uptime.stamps[count:]
    expect(
        later == pytest.approx([int(before) + number for number in (1, 2, 3)]),
        f'After a reset at {before:g} s uptimes came at {later} s: the reset must not restart the timer.',
        'reset-only' if count == int(before) else 'uptime-rate',
    )
    expect(uptime.data[count:] != [0, 1, 2], 'The first uptime after a reset is 0, expected 1.', 'reset')
    expect(
        uptime.data[count:] == [1, 2, 3],
        f'After a reset uptime says {uptime.data[count:]}, expected [1, 2, 3].',
        'reset',
    )
    for _ in range(3):
        press(learner, button, learner.random.randint(25, 30))
        learner.run(1.0)
    learner.run(1.0)
    expect(
        uptime.data[count + 3 :] == [1, 1, 1, 2],
        f'In each of three seconds came many resets; uptime says {uptime.data[count + 3 :]}, expected [1, 1, 1, 2].',
        'reset',
    )
    count, pause = len(uptime), learner.random.choice([0.2, 0.35, 0.45])
    learner.run((0.9 - learner.now / 1e9) % 1)
    for rest in (pause, 2.0):
        press(learner, button, 1)
        learner.run(rest)
    expect(
        uptime.data[-3:] == [1, 1, 2],
        f'A reset came 0.1 s before an uptime, and another one {pause} s after the first; then uptime says '
        f'{uptime.data[count:]}, expected … 1, 1, 2.',
        'reset',
    )


@pytest.mark.rules('reset-only')
def test_reset_leaves_led(learner):
    """A reset does not touch the LED, whether it is on or off.

    LED and uptime are two states: reset one of them.
    """
    led = learner.listen('/led', Bool)
    button = learner.talk('/reset', Empty)
    with waiting('no-wait'):
        learner.start('Heartbeat')
    learner.settle()
    with waiting('no-wait'):
        learner.run(1.3)  # after five messages the LED is on
    begin = led.data[:1] or [True]
    for seconds in (1.25, 0.75):
        button.send(Empty())
        learner.run(seconds)
    rhythm = [(n % 2 == 0) is begin[0] for n in range(len(led))]
    expect(
        led.data == rhythm,
        'The LED missed a change at the reset: do not reset its state.',
        'reset-only' if led.data[:5] == rhythm[:5] else 'led',
    )
    expect(
        led.stamps == pytest.approx([n / 4 for n in range(1, 14)]),
        f'With resets at 1.3 and 2.55 s, LED messages came at {led.stamps} s: its timer goes on.',
        'reset-only' if led.stamps[:5] == pytest.approx([0.25, 0.5, 0.75, 1.0, 1.25]) else 'led-rate',
    )


@pytest.mark.rules('reset')
def test_every_reset(learner):
    """Every reset works, also the second and one before the first second.

    The callback sets the counter to 0 each time.
    """
    uptime = learner.listen('/uptime', Int32)
    button = learner.talk('/reset', Empty)
    with waiting('no-wait'):
        learner.start('Heartbeat')
    button.send(Empty())
    with waiting('no-wait'):
        learner.run(2.5)
    button.send(Empty(), Empty())
    learner.run(1.0)
    button.send(Empty())
    learner.run(2.0)
    expect(
        len(uptime) == 5,
        f'{len(uptime)} uptimes came in 5.5 s with some resets, expected 5.',
        'reset-only' if uptime.stamps[:2] == [1.0, 2.0] or len(uptime) > 5 else 'uptime-rate',
    )
    expect(
        uptime.data == [1, 2, 1, 1, 2],
        f'With resets at 0, 2.5 and 3.5 s uptime says {uptime.data}, expected [1, 2, 1, 1, 2].',
        'reset',
    )


@pytest.mark.rules('own-state', 'no-wait')
def test_two_heartbeats(learner):
    """Two heartbeats in one program do not disturb each other.

    State belongs to the object: self.…, set in __init__.
    """
    led, uptime = learner.listen('/led', Bool), learner.listen('/uptime', Int32)
    with waiting('no-wait'):
        first = learner.start('Heartbeat')
    learner.settle()
    with waiting('no-wait'):
        learner.run(learner.random.randint(1, 3) + 0.3)
    counts = len(led), len(uptime)
    learner.start('Heartbeat', beside=first)
    expect(not learner.slept, 'The constructor waits in a loop; the timers do the waiting.', 'no-wait')
    with waiting('no-wait'):
        learner.run(2.6)
    expect(uptime.data or led.data, 'Two heartbeats have said nothing on /uptime and /led.', 'uptime')
    odd = [number for stamp, number in zip(uptime.stamps, uptime.data, strict=True) if stamp % 1 > 1e-6]
    expect(
        not uptime.data or odd == [1, 2],
        f'A second heartbeat says the uptimes {odd}, expected 1, 2: they share state. It belongs to the object (self).',
        'own-state' if uptime.data[:1] == [1] else 'uptime',
    )
    expect(
        uptime.data[:1] != [1]
        or len(uptime) - counts[1] - 2 == 2
        and [n for n in uptime.data[counts[1] :] if n not in (1, 2)]
        == [n for n in (counts[1] + 1, counts[1] + 2) if n not in (1, 2)],
        f'With a second heartbeat beside it, the uptimes are {uptime.data}: they share state.',
        'own-state',
    )
    lit = [on for stamp, on in zip(led.stamps, led.data, strict=True) if (stamp * 4) % 1 > 1e-6]
    expect(
        not lit or lit == [lit[0] is (n % 2 == 0) for n in range(len(lit))] and lit[0] is led.data[0],
        'Two heartbeats share the state of the LED. It belongs to the object (self).',
        'own-state',
    )


@pytest.mark.rules('own-state')
def test_reset_of_one(learner):
    """Of two heartbeats in one program, in two namespaces, a reset reaches one.

    What a reset changes belongs to the object: self.…, set in __init__.
    """
    uptime = learner.listen('/uptime', Int32)
    other, button = learner.listen('/left/uptime', Int32), learner.talk('/left/reset', Empty)
    with waiting('no-wait'):
        first = learner.start('Heartbeat')
        learner.start('Heartbeat', beside=first, remap={'__ns': '/left'})
    learner.settle()
    seconds = learner.random.randint(2, 4)
    with waiting('no-wait'):
        learner.run(seconds + 0.4, step=0.5)
    button.send(Empty())
    learner.run(2.0, step=0.5)
    wanted, after = list(range(1, seconds + 3)), [*range(1, seconds + 1), 1, 2]
    expect(
        uptime.data[:2] == [1, 2] == other.data[:2],
        f'Of two heartbeats in one program one says {uptime.data}, the other {other.data}, expected 1, 2 … of both.',
        'own-state' if 1 in (*uptime.data[:1], *other.data[:1]) else 'uptime',
    )
    expect(
        other.data == after or len(other) != len(after),  # other tests look at the rhythm
        f'After a reset the uptimes are {other.data}, expected {after}.',
        'reset',
    )
    expect(
        uptime.data == wanted,
        f'A heartbeat in another namespace was reset at {seconds + 0.4} s, and the uptimes of this one are '
        f'{uptime.data}, expected {wanted}. What a reset changes belongs to the object (self).',
        'own-state',
    )


@pytest.mark.rules('node', 'topics', 'qos')
def test_namespace(learner):
    """In a namespace all three topics move with the node, and the node is called heartbeat.

    Relative names have no leading slash.
    """
    space = f'/side{learner.random.randint(2, 9)}'
    learner.listen(f'{space}/uptime', Int32), learner.listen(f'{space}/led', Bool)
    learner.talk(f'{space}/reset', Empty)
    with waiting('no-wait'):
        node = learner.start('Heartbeat', remap={'__ns': space})
    check_name(node, 'heartbeat', 'node')
    for kind, topic in (('publisher', 'led'), ('publisher', 'uptime'), ('subscription', 'reset')):
        check_topic(learner, kind, space, topic, 'topics')
        check_queue(learner, kind, f'{space}/{topic}', 10, 'qos')
