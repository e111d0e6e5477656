"""A beacon that nobody hears at first: for exercise 3.1."""

import re

from std_msgs.msg import String

from helpers.checks.chapter_03.endpoints import check_topic
from helpers.runner import about, expect, waiting


def check_unheard(learner, quarters: int) -> None:
    """A beacon without a namespace counts on while nobody listens, for so many periods."""
    learner.run(learner.random.uniform(1.0, 9.0))  # its count does not depend on the clock
    with waiting('at-once'):
        learner.start('Beacon')
    check_topic(learner, 'publisher', '', 'beacon', 'topic')
    with about('texts'):
        learner.run(quarters / 4 + 0.1)
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
