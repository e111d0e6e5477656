"""Visible tests of exercise 7.7, the mystery."""

import pytest

from helpers.checks.chapter_07.cases import WHY, Case
from helpers.checks.chapter_07.findings import compare

pytestmark = pytest.mark.exercise('7.7')


def test_nothing_wrong(learner):
    """A case without a fault gives an empty list.

    Each of your six tools gives one for its part.
    """
    compare(learner.call('triage', Case(learner.random).case), [], WHY)


def test_two_faults(learner):
    """A machine and a model with a fault each: two findings, and both are repaired.

    Ask all tools, and return all findings.
    """
    case = Case(learner.random, {'machine': ('key',), 'model': ('mass',)})
    compare(learner.call('triage', case.case), case.expected, WHY)
    case.robot.check(case.repaired(learner)['urdf'])
