"""Visible tests of exercise 3.1, a beacon."""

from itertools import pairwise

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


@pytest.mark.rules('at-once', 'node', 'topic', 'qos', 'first', 'texts', 'rate', 'own-count')
def test_beacon(learner):
    """A Beacon publishes 'alive 1', 'alive 2', … on its topic, 4 times a second.

    Look at the text you publish, and at where you add 1 to the counter.
    """
    random = learner.random
    space = robot(random)
    quarters = random.randint(17, 24)  # more than the 4 s of somebody who takes the rate for the period
    heard = learner.listen(f'{space}/beacon', String)
    with waiting('at-once'):
        beacon = learner.start('Beacon', remap={'__ns': space})
    check_awake(learner)
    check_name(beacon, 'beacon', 'node')
    check_topic(learner, 'publisher', space, 'beacon', 'topic')
    check_queue(learner, 'publisher', f'{space}/beacon', 10, 'qos')
    learner.settle()
    check_callbacks_do_not_sleep(learner)
    with about('texts'):
        learner.run(quarters / 4, step=1.0)
    check_texts(heard.data, heard.stamps)
    check_times(heard.stamps, quarters)
    check_topic(learner, 'publisher', space, 'beacon', 'topic')  # no callback has made another one
    begin = learner.now / 1e9
    with about('own-count'):
        learner.start('Beacon', beside=beacon)
        learner.settle()
        check_own_publishers(learner, f'{space}/beacon', 2)
        learner.run(1.1, step=1.0)
    check_second(heard, quarters, begin)
    check_own_topic(learner, beacon, heard)


@pytest.mark.rules('topic', 'rate', 'texts')
def test_nobody_listens(learner):
    """A Beacon publishes and counts whether somebody listens or not, in each call of its timer, without end.

    Publish in each call of the timer, and add 1 to the number there. The node has a name, and no namespace of its own.
    """
    check_unheard(learner, learner.random.randint(2, 6))


def check_texts(texts, stamps):
    expect(texts, 'Nothing was published. Is there a timer, and does its callback publish?', 'rate')
    expect(texts[0] != 'alive 0', "The first text is 'alive 0': the count must begin at 1.", 'texts')
    expect(
        texts[0] != 'alive 2',
        "The first text that arrives is 'alive 2'. Publish in the timer only: what the "
        'constructor publishes, nobody can hear yet.',
        'first',
    )
    expect(
        texts[:2] != ['alive 1', 'alive 1'] or stamps[0] > 0.2 or len(set(texts)) == 1,
        'The constructor publishes. Publish in the timer only: one period must pass before the first message.',
        'first',
    )
    expect(
        len(texts) == 1 or len(set(texts)) > 1,
        f'The text never changes ({texts[0]!r}): add 1 to the counter in each call.',
        'texts',
    )
    for number, text in enumerate(texts, start=1):
        expect(text == f'alive {number}', f'Text number {number} is {text!r}, expected {f"alive {number}"!r}.', 'texts')


def check_times(stamps, quarters):
    seconds = quarters / 4 + 0.1
    expect(
        len(stamps) != 1,
        f'One message came in {seconds:g} s, after {stamps[0]:g} s. create_timer wants the period, not the rate.',
        'rate',
    )
    expect(
        stamps[0] >= 0.25,
        f'The first message came after {stamps[0]:g} s: one period, 0.25 s, must pass before it.'
        + (' Publish in the timer only.' if stamps[0] < 0.01 else ''),
        'first' if stamps[1] - stamps[0] == pytest.approx(0.25) else 'rate',
    )
    steady = [later - earlier for earlier, later in pairwise(stamps)] == pytest.approx([0.25] * (len(stamps) - 1))
    expect(
        stamps[0] == pytest.approx(0.25) or not steady,
        f'The first message came after {stamps[0]:g} s, expected after one period, 0.25 s.',
        'first',
    )
    expect(
        len(stamps) == quarters, f'{len(stamps)} messages came in {seconds:g} s; at 4 Hz there are {quarters}.', 'rate'
    )
    expect(
        stamps == pytest.approx([number / 4 for number in range(1, quarters + 1)]),
        f'The messages came at {", ".join(f"{stamp:g}" for stamp in stamps[:4])} … s, expected 0.25, 0.5, 0.75, 1 … s.',
        'rate',
    )


def check_second(heard, quarters, begin):
    """What came after a second beacon had been started, at `begin`, in the same program."""
    later = list(zip(heard.stamps, heard.data, strict=True))[quarters:]
    second = [(stamp - begin, text) for stamp, text in later if (stamp * 4) % 1]
    expect(
        not second or second[0][0] > 0.2,
        'The constructor publishes. Publish in the timer only: one period must pass before the first message.',
        'first',
    )
    wanted = [f'alive {number}' for number in range(1, 5)]
    texts = [text for _, text in second]
    expect(
        not texts or texts[0] == 'alive 1',
        f'A second beacon in the same program begins with {", ".join(texts[:1])!r}: the two share one counter. It '
        'belongs to the object (self.count), not to the class or the module.',
        'own-count',
    )
    expect(texts == wanted, f'A second beacon in the same program says {texts}, expected {wanted}.', 'own-count')
    first = [text for stamp, text in later if not (stamp * 4) % 1]
    wanted = [f'alive {quarters + number}' for number in range(1, 5)]
    expect(
        first == wanted,
        f'When a second beacon starts, the first one says {first}, expected {wanted}: it must not be disturbed.',
        'own-count',
    )
