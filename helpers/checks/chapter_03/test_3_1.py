"""Visible tests of exercise 3.1, a beacon."""

import pytest
from std_msgs.msg import String

from helpers.runner import expect

pytestmark = pytest.mark.exercise('3.1')


def test_texts(learner):
    """In 2 seconds a Beacon publishes 'alive 1' to 'alive 8' on the topic beacon.

    Look at the text you publish, and at where you add 1 to the counter.
    """
    heard = learner.listen('/beacon', String)
    learner.start('Beacon')
    learner.run(2.1)
    expect(heard.data,
           'Nothing was published on /beacon in 2 seconds. Is there a timer, and does its callback publish?')
    expect(heard.data[0] != 'alive 0', "The first text is 'alive 0': the count must begin at 1.")
    expect(heard.data[0] != 'alive 2', "The first text that arrives is 'alive 2'. Publish in the timer only: what the "
                                       'constructor publishes, nobody can hear yet.')
    expect(len(set(heard.data)) > 1, f'The text never changes ({heard.data[0]!r}): add 1 to the counter in each call.')
    wanted = [f'alive {number}' for number in range(1, len(heard.data) + 1)]
    expect(heard.data == wanted, f'The texts are {heard.data[:4]} …, expected {wanted[:4]} …')


def test_rate(learner):
    """The beacon publishes 4 times a second.

    The first argument of create_timer is a period in seconds, not a rate.
    """
    heard = learner.listen('/beacon', String)
    learner.start('Beacon')
    learner.run(4.9)
    expect(len(heard) != 1, 'One message in 4.9 s: the period is 4 s. create_timer wants the period, not the rate.')
    expect(len(heard) == 19, f'{len(heard)} messages came in 4.9 s; at 4 Hz there are 19.')
