"""Visible tests of exercise 1.1, choose a distribution."""

import pytest

from helpers.checks.chapter_01 import distributions
from helpers.runner import about

pytestmark = pytest.mark.exercise('1.1')


@pytest.mark.rules('pair', 'ends-last', 'months', 'ended', 'to-come', 'unknown', 'table')
def test_choice(learner):
    """On every day, each Ubuntu gets the distribution whose support ends last, or the reason why there is none.

    Collect the rows of this Ubuntu, then those that are supported in the month of today.
    """
    with about('unknown'):
        distributions.check(learner, distributions.cases(learner.random))
    with about('table'):
        distributions.check(learner, distributions.drawn_cases(learner.random))
    with about('table'):
        distributions.check(learner, distributions.crowded_cases(learner.random))
    with about('months'):
        distributions.check(learner, distributions.border_cases(learner.random))
