"""Visible tests of exercise 1.1, choose a distribution."""

import pytest

from helpers.runner import expect

pytestmark = pytest.mark.exercise('1.1')


def ask(learner, ubuntu, today, wanted, hint=''):
    got = learner.call('choose_distribution', ubuntu, today)
    expect(got == list(wanted), f'Ubuntu {ubuntu} on {today} gives {got!r}, expected {wanted!r}. {hint}')


def test_the_course_chooses_jazzy(learner):
    """On 21 November 2026, Ubuntu 24.04 gets Jazzy: ('jazzy', 'supported').

    Kilted is for 24.04, too, and newer. Which of the two ends last?
    """
    ask(learner, '24.04', '2026-11-21', ('jazzy', 'supported'), 'Return the distribution whose support ends last.')


def test_end_of_life(learner):
    """For Ubuntu 20.04 nothing is supported any more: (None, 'end of life').

    Compare the month of today with the last month of each distribution.
    """
    ask(learner, '20.04', '2026-11-21', (None, 'end of life'))


def test_unknown_ubuntu(learner):
    """The table has nothing for Ubuntu 23.10: (None, 'unknown Ubuntu').

    Do not guess a neighbour.
    """
    ask(learner, '23.10', '2026-11-21', (None, 'unknown Ubuntu'))
