"""Visible tests of exercise 3.3, heartbeat."""

import pytest
from std_msgs.msg import Bool, Empty, Int32

from helpers.checks.chapter_03.endpoints import check_name, check_queue, check_topic, robot
from helpers.checks.chapter_03.heartbeats import check_starts, check_unheard
from helpers.runner import about, expect, waiting

pytestmark = [pytest.mark.exercise('3.3'), pytest.mark.wiring(type='topics', qos='qos', namespace='topics')]

ENDS = (('publisher', 'led'), ('publisher', 'uptime'), ('subscription', 'reset'))


@pytest.mark.rules('node', 'topics', 'qos', 'led', 'led-rate', 'uptime', 'uptime-rate', 'reset', 'no-wait')
def test_heartbeat(learner):
    """A Heartbeat blinks every 0.25 s and counts seconds, also after a minute.

    Two timers. Their callbacks return at once.
    """
    led, uptime, button, _ = begun(learner)
    check_minute(learner, led, uptime)
    check_late_reset(learner, uptime, button)


@pytest.mark.rules('reset', 'reset-only', 'no-wait', 'own-state')
def test_reset(learner):
    """A Heartbeat counts anew after each reset, and two of them do not disturb each other.

    The callback of the reset sets the counter to 0, and nothing else. The counter belongs to the object.
    """
    led, uptime, button, node = begun(learner)
    check_resets(learner, led, uptime, button)
    check_second(learner, led, uptime, button, node)


def begun(learner):
    """A Heartbeat in a namespace, whose first seconds are judged: led, uptime, what speaks on reset, and the node."""
    random = learner.random
    space = robot(random)
    led, uptime = learner.listen(f'{space}/led', Bool), learner.listen(f'{space}/uptime', Int32)
    button = learner.talk(f'{space}/reset', Empty)
    with waiting('no-wait'):
        node = learner.start('Heartbeat', remap={'__ns': space})
    expect(not learner.slept, 'The constructor sleeps, or waits in a loop. The timers do the waiting.', 'no-wait')
    check_name(node, 'heartbeat', 'node')
    for kind, topic in ENDS:
        check_topic(learner, kind, space, topic, 'topics')
        check_queue(learner, kind, f'{space}/{topic}', 10, 'qos')
    learner.settle()
    seconds = random.randint(3, 5)
    fraction = random.choice([0.1, 0.3, 0.4, 0.6, 0.9])
    with waiting('no-wait'):
        learner.run(seconds + fraction, step=0.5)
    expect(
        not learner.slept,
        'A callback sleeps, or waits in a loop, and the whole node stands still meanwhile. The timers do the waiting.',
        'no-wait',
    )
    check_led(led, seconds + fraction)
    check_uptime(uptime, seconds)
    return led, uptime, button, node


@pytest.mark.rules('led', 'uptime')
def test_started_at_any_time(learner):
    """A Heartbeat begins with True and 1, whenever it is started.

    Keep the light and the number in attributes; do not compute them from the clock.
    """
    check_unheard(learner, check_starts(learner))


def check_led(led, seconds):
    expect(led.messages, f'Nothing came on led in {seconds:g} s.', 'led-rate')
    wanted = [number / 4 for number in range(1, int(seconds * 4) + 1)]
    expect(
        led.stamps == pytest.approx(wanted),
        f'In {seconds:g} s {len(led)} messages came on led, the first ones at '
        f'{told(led.stamps)} s. Every 0.25 s gives {len(wanted)}, at 0.25, 0.5, 0.75 … s.',
        'led-rate',
    )
    expect(led.data[0], 'The first LED message is False; it begins with True.', 'led')
    expect(
        led.data == [number % 2 == 0 for number in range(len(led))],
        f'The LED says {", ".join(map(str, led.data[:6]))} …; it must change with every message: True, False, True …',
        'led',
    )


def check_uptime(uptime, seconds):
    expect(uptime.messages, f'Nothing came on uptime in {seconds} s. Two jobs need two timers.', 'uptime-rate')
    expect(
        uptime.stamps == pytest.approx(range(1, seconds + 1)),
        f'The uptimes came at {told(uptime.stamps)} s, expected 1, 2, 3 … s.',
        'uptime-rate',
    )
    expect(
        uptime.data == list(range(1, seconds + 1)),
        f'The uptimes of the first {seconds} s are {uptime.data}, expected 1, 2, 3 …',
        'uptime',
    )


def check_minute(learner, led, uptime):
    """After more than a minute without a reset both go on as before."""
    with waiting('no-wait'):
        learner.run(60, step=0.5)
    wanted = list(range(1, int(learner.now / 1e9) + 1))
    for said, right in zip(uptime.data, wanted, strict=False):
        expect(
            said == right,
            f'After {right - 1} uptime says {said}, expected {right}: it counts on, also after a minute.',
            'uptime',
        )
    expect(len(uptime) == len(wanted), f'In {len(wanted)} s {len(uptime)} messages came on uptime.', 'uptime-rate')
    expect(
        len(led) == int(learner.now / 1e9 * 4 + 1e-6),
        f'In {learner.now / 1e9:g} s {len(led)} messages came on led; every 0.25 s also after a minute.',
        'led-rate',
    )
    expect(
        led.data == [number % 2 == 0 for number in range(len(led))],
        'In more than a minute the LED does not change with every message.',
        'led',
    )


def check_late_reset(learner, uptime, button):
    """A reset works after more than a minute, too, whatever has been counted by then."""
    counted, count = uptime.data[-1], len(uptime)
    press(learner, button, 1)
    with waiting('no-wait'):
        learner.run(2.0, step=0.5)
    expect(
        uptime.data[count:] == [1, 2] or len(uptime) != count + 2,  # the other test looks at the rhythm
        f'After the uptime {counted} came a reset, and then the uptimes {told(uptime.data[count:])}, expected 1, '
        f'2{": a reset sets the counter to 0, however far it has counted" if uptime.data[-1] > counted else ""}.',
        'reset',
    )


def check_resets(learner, led, uptime, button):
    """Resets in both halves of a second, while the LED is on and while it is off, two in a row, and many.

    At last two that lie close together, the one before a full second and the other one after it.
    """
    before = round((0.85 - learner.now / 1e9) % 1, 3)  # the pauses before it make whole seconds
    many = learner.random.randint(45, 60)
    for presses, rest in ((1, 2.25), (2, 1.5), (many, 2.25), (1, 3.0 + before), (1, 0.3), (1, 3.0)):
        counts, at = (len(led), len(uptime)), learner.now / 1e9
        press(learner, button, presses)
        expect(
            (len(led), len(uptime)) == counts,
            'The reset itself published something: only the timers publish.',
            'reset-only',
        )
        with waiting('no-wait'):
            learner.run(rest, step=0.5)
        begin, count = int(at) + 1, int(at + rest) - int(at)
        after = uptime.data[counts[1] :]
        expect(
            uptime.stamps[counts[1] :] == pytest.approx(range(begin, begin + count)),
            f'After a reset at {at:g} s uptimes came at {told(uptime.stamps[counts[1] :])} s, expected '
            f'{begin}, {begin + 1} … s: the reset must not restart or stop a timer.',
            'reset-only',
        )
        lit = led.data[counts[0] :]
        quarter = int(at * 4 + 1e-6)
        expect(
            lit == [number % 2 == 0 for number in range(quarter, quarter + len(lit))],
            f'After a reset at {at:g} s the LED lost its rhythm of True and False: the reset must not touch it.',
            'reset-only',
        )
        expect(
            led.stamps[counts[0] :]
            == pytest.approx([number / 4 for number in range(quarter + 1, int((at + rest) * 4 + 1e-6) + 1)]),
            f'After a reset at {at:g} s LED messages came at {told(led.stamps[counts[0] :])} s: its timer must go on.',
            'reset-only',
        )
        expect(after[0] != begin, f'A message on reset changes nothing: uptime counts on, {told(after)}.', 'reset')
        expect(
            after == list(range(1, count + 1)),
            f'After a reset at {at:g} s the uptimes are {told(after)}; the next one must be 1, then 2.',
            'reset',
        )
    expect(not learner.slept, 'A callback sleeps, or waits in a loop. The timers do the waiting.', 'no-wait')


def press(learner, button, presses: int) -> None:
    """So many messages on reset at one moment; no more at a time than the queue holds."""
    for begin in range(0, presses, 9):
        button.send(*min(9, presses - begin) * [Empty()])
        with waiting('no-wait'):
            learner.settle()


def check_second(learner, led, uptime, button, node):
    """A second heartbeat in the same process, in a namespace of its own: it begins between two beats of the first."""
    space = '/second'
    light, number = learner.listen(f'{space}/led', Bool), learner.listen(f'{space}/uptime', Int32)
    learner.talk(f'{space}/reset', Empty)
    begin = learner.now / 1e9
    counts = len(led), len(uptime)
    with about('own-state'):
        learner.start('Heartbeat', beside=node, remap={'__ns': space})
    # A loop that only counts is noticed when it runs again.
    expect(not learner.slept, 'The constructor waits in a loop. The timers do the waiting.', 'no-wait')
    with about('own-state'):
        learner.settle()
        expect(
            not light.data and not number.data,
            f'A second heartbeat said {told(light.data + number.data)} in its constructor. Only the timers publish.',
            'led-rate',
        )
        learner.run(2.1, step=0.5)
    expect(
        light.data == 4 * [True, False],
        f'A second heartbeat in the same process says {told(light.data)} on led, expected True, '
        'False, True …: they share state. It belongs to the object (self).',
        'own-state',
    )
    quarter = int(begin * 4 + 1e-6)
    others = led.data[counts[0] :]
    expect(
        others == [number % 2 == 0 for number in range(quarter, quarter + len(others))],
        'When a second heartbeat starts, the LED of the first one loses its rhythm: they share state.',
        'own-state',
    )
    expect(
        number.data == [1, 2],
        f'A second heartbeat in the same process says the uptimes {told(number.data)}, expected 1, '
        '2: they share state. It belongs to the object (self).',
        'own-state',
    )
    first = uptime.data[counts[1] :]
    wanted = list(range(4, 4 + len(first)))  # after the seconds since the last reset
    expect(
        first == wanted,
        f'When a second heartbeat starts, the first one says the uptimes {told(first)}, expected '
        f'{told(wanted)}: they share state. It belongs to the object (self).',
        'own-state',
    )
    count = len(uptime)
    button.send(Empty())
    with about('own-state'):
        learner.settle()
        learner.run(2.0, step=0.5)
    first, second = uptime.data[count:], number.data[2:]
    expect(
        (first, second) == ([1, 2], [3, 4]),
        'Of two heartbeats in the same process, in two namespaces, the first one heard a reset. In the next two '
        f'seconds its uptimes are {told(first)}, expected 1, 2; those of the other one are {told(second)}, expected '
        '3, 4. What a reset changes belongs to the object (self).',
        'own-state',
    )


def told(values) -> str:
    """The first values, as a list in a sentence."""
    return ', '.join(f'{value:g}' if isinstance(value, float) else str(value) for value in values[:4]) or 'nothing'
