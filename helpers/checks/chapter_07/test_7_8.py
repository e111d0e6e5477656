"""Visible tests of exercise 7.8, five systems that run."""

import pytest

from helpers.checks.chapter_07 import live_systems

pytestmark = pytest.mark.exercise('7.8')


@pytest.mark.rules('name', 'cause', 'both', 'nothing-else', 'where', 'evidence')
@pytest.mark.parametrize('number', live_systems.NUMBERS)
def test_findings(learner, number):
    """Your findings are the faults of this system: cause, place and evidence.

    The task says how the system should be; a file or a tool says how it is.
    """
    live_systems.judge_findings(learner, number)


@pytest.mark.rules('repaired', 'only-there')
@pytest.mark.parametrize('number', live_systems.NUMBERS)
def test_repair(learner, number):
    """After your changes the system runs as its task says, and they are where your findings are.

    system.changes() gives them in this form.
    """
    live_systems.judge_repair(learner, number)
