"""Visible tests of exercise 7.8, five systems that run."""

import pytest

from helpers.checks.chapter_07 import live_systems

pytestmark = pytest.mark.exercise('7.8')


@pytest.mark.rules('name', 'cause', 'both', 'nothing-else', 'where', 'evidence')
def test_findings(learner):
    """Your findings are the faults of the five systems: fault, cause, where and evidence.

    The task says how the system should be; a file or a tool says how it is.
    """
    live_systems.judge_all(learner, live_systems.judge_findings)


@pytest.mark.rules('repaired', 'only-there')
def test_repair(learner):
    """After your changes the systems run as their tasks say, and they are where your findings are.

    system.changes() gives them in this form.
    """
    live_systems.judge_all(learner, live_systems.judge_repair)
