"""Hidden tests of exercise 1.1, choose a distribution."""

import pytest

from helpers.checks.chapter_01 import distributions
from helpers.runner import about

pytestmark = pytest.mark.exercise('1.1')


@pytest.mark.weight(3)
@pytest.mark.rules('pair', 'ends-last', 'months', 'ended', 'to-come', 'unknown')
def test_releases(learner):
    """The course's own table, on other days.

    Compare months with months, and look only at rows whose first entry equals `ubuntu`.
    """
    with about('unknown'):
        for _ in range(3):
            distributions.check(learner, distributions.cases(learner.random))


@pytest.mark.weight(3)
@pytest.mark.rules('table', 'ends-last', 'months', 'ended', 'to-come', 'unknown')
def test_other_tables(learner):
    """The answers come from the table that is given, also for distributions that nobody knows today.

    Use the argument `releases`, and nothing that you know by heart.
    """
    with about('unknown'):
        distributions.check(learner, distributions.cases(learner.random))
    with about('table'):
        for _ in range(4):
            distributions.check(learner, distributions.drawn_cases(learner.random))
            distributions.check(learner, distributions.border_cases(learner.random))
            distributions.check(learner, distributions.crowded_cases(learner.random))
