"""Hidden tests of exercise 7.8, five systems that run: copies with other values, started in another order."""

import pytest

from helpers.checks.chapter_07 import live_systems

pytestmark = pytest.mark.exercise('7.8')


@pytest.mark.rules('name', 'cause', 'both', 'nothing-else', 'where', 'evidence')
@pytest.mark.parametrize('number', live_systems.NUMBERS)
def test_findings_again(learner, number):
    """Your findings are the faults of this system: fault, cause, where and evidence.

    The task says how the system should be; a file or a tool says how it is.
    """
    live_systems.judge_findings(learner, number)


@pytest.mark.rules('repaired', 'only-there')
@pytest.mark.weight(2)
@pytest.mark.parametrize('number', live_systems.NUMBERS)
def test_panel_first(learner, number):
    """After your changes the system runs as its task says, also if the robot is started later than the panel.

    A repair is in the files: it does not depend on what happened to run when you made it.
    """
    live_systems.judge_repair(learner, number, panel_first=True)
