"""A beacon that nobody hears at first, that is called late, and that goes on: for exercise 3.1."""

import re
from itertools import pairwise

from std_msgs.msg import String

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.checks.chapter_03.endpoints import check_topic
from helpers.runner import about, expect, waiting

MANY = 65.0  # s: more texts than anybody writes down beforehand, and than fit into a byte


def check_unheard(learner, quarters: int) -> None:
    """A beacon without a namespace counts on while nobody listens, for so many periods; and then for long."""
    learner.run(learner.random.uniform(1.0, 9.0), step=9.0)  # its count does not depend on the clock
    with waiting('at-once'):
        learner.start('Beacon')
    check_awake(learner)  # here, too: who waits for a listener has none
    check_topic(learner, 'publisher', '', 'beacon', 'topic')
    check_callbacks_do_not_sleep(learner)
    with about('texts'):
        learner.run(quarters / 4, step=1.0)
    heard = learner.listen('/beacon', String)
    learner.settle()
    with about('texts'):
        learner.run(0.5)
    numbers = [int(found) for text in heard.data for found in re.findall(r'^alive (\d+)$', text)]
    counts = len(set(numbers)) > 1  # else another rule is broken, and so it is where a text has no number
    expect(
        heard.messages and not (counts and numbers[0] < quarters),
        f'Who listens from {quarters / 4 + 0.1:g} s on hears {heard.data} in half a second, expected '
        f"'alive {quarters + 1}' first: a beacon publishes and counts whether somebody listens or not.",
        'rate',
    )
    _check_late_call(learner, heard)
    count = len(heard)
    with about('texts'):
        learner.run(MANY, step=1.0)
    _check_numbers(heard.data[count - 1 :])
    expect(
        heard.stamps[-1] > learner.now / 1e9 - 1,
        f'After {heard.data[-1]!r} nothing more was published, for more than a second. A beacon goes on without end, '
        'and so do its numbers.',
        'texts',
    )


def check_awake(learner) -> None:
    """The constructor has returned at once: what it does itself takes no time."""
    expect(
        not learner.slept,
        'The constructor sleeps or spins, or a thread that it starts sleeps. A timer does the waiting: the constructor '
        'only prepares.',
        'at-once',
    )


def check_callbacks_do_not_sleep(learner) -> None:
    """Let 0.1 s pass, in which a beacon has nothing to do: who sleeps in callbacks would take minutes for a minute."""
    before = learner.slept  # by the constructor
    with about('texts'):
        learner.run(0.1)
    expect(
        learner.slept <= before,
        'A callback sleeps or waits, and this before the first period has passed. A timer with the period 0.25 s does '
        'the waiting.',
        'rate',
    )


def _check_numbers(texts: list[str]) -> None:
    """The number of each text is that of the one before and 1, however large it is."""
    found = re.fullmatch(r'alive (\d+)', texts[0])
    for number, text in enumerate(texts, start=int(found[1])) if found else ():  # else another test says so
        expect(
            text == f'alive {number}',
            f"After 'alive {number - 1}' came {text!r}, expected 'alive {number}': the numbers go on without end.",
            'texts',
        )


def _check_late_call(learner, heard) -> None:
    """When the clock leaps, the timer is called once, and its text has the next number."""
    before = heard.data[-1]
    count = len(heard)
    with about('texts'):
        learner.jump(2.0)
        learner.run(0.5)
    found = [re.fullmatch(r'alive (\d+)', text) for text in (before, *heard.data[count : count + 2])]
    numbers = [int(match[1]) for match in found if match]
    expect(
        len(numbers) < len(found) or all(after in (last, last + 1) for last, after in pairwise(numbers)),
        f'After {before!r} the timer was called late, as on a busy machine, and the text was '
        f'{heard.data[count : count + 1]}. The number counts the messages: add 1 in each call, and do not compute it '
        'from the time.',
        'texts',
    )


def check_own_publishers(learner, topic: str, count: int) -> None:
    """So many beacons in one program have a publisher each."""
    found = len(learner.depths('publisher', topic))
    expect(
        found >= count,
        f'{count} beacons in one program have {found} publisher together: what one of them says goes out of the '
        'publisher of another one, and ends with it. Each constructor makes its own (self.create_publisher).',
        'topic',
    )


def check_own_topic(learner, beacon, heard) -> None:
    """A beacon goes on to speak on its own topic, which is `heard`, when another one is made in another namespace."""
    others = learner.listen(f'{OTHER}/beacon', String)
    with about('own-count'):
        learner.start('Beacon', beside=beacon, remap={'__ns': OTHER, '__node': 'tower'})
        learner.settle()
        expect(
            not learner.endpoints(f'{OTHER}/tower').publishers,
            'A beacon that was started under another name, tower, publishes on the topic tower. The topic is beacon, '
            'whatever the node is called: write its name.',
            'topic',
        )
        for recorded in (heard, others):
            recorded.clear()
        learner.run(0.6)
    check_own('Beacon', 'They ran for 0.6 s', len(heard), len(others), 'beacon', 'publisher', 'topic')
