"""Hidden tests of exercise 1.2, read an environment. The environments are drawn afresh."""

import pytest

from helpers.checks.chapter_01 import environments

pytestmark = pytest.mark.exercise('1.2')


@pytest.mark.weight(4)
@pytest.mark.rules(
    'dictionary', 'not-sourced', 'mixed', 'ros-distro', 'workspace', 'python', 'domain', 'off', 'unknown', 'missing'
)
def test_single_faults(learner):
    """Environments without a fault and with one, of several distributions.

    A workspace folder may be called anything. Only /opt/ros/NAME is a distribution.
    """
    for _ in range(4):
        environments.check(learner, environments.cases(learner.random))


@pytest.mark.weight(2)
@pytest.mark.rules('every-fault')
def test_several_faults(learner):
    """Several faults at once are all named, and nothing else.

    One `if` for each variable; an early return hides the others.
    """
    environments.check(learner, environments.cases(learner.random))
    environments.check(learner, environments.several(learner.random, (2, 2, 3, 3, 4, 4, 4)))
