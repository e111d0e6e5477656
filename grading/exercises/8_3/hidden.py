"""Hidden tests of exercise 8.3, two governors: in other namespaces, and with other values in the installed file."""

import pytest

from helpers.checks.chapter_08 import fleets

pytestmark = pytest.mark.exercise('8.3')


@pytest.mark.rules('installed-file')
def test_no_values_in_the_launch_file(learner):
    """The values come from the file: who changes the file changes the robots.

    In the launch file, parameters= is a list with the path of the installed file.
    """
    fleets.judge_installed_file(learner)


@pytest.mark.rules('nodes', 'types', 'robot1', 'robot2', 'installed-file', 'max-linear', 'rest')
@pytest.mark.weight(2)
def test_values(learner):
    """robot1 has max_linear 1 and the mode normal; robot2 has max_linear 0.6 and the mode slow; both have the rate 20.

    A later block of the file overrides an earlier one: the block for all comes first.
    """
    fleets.judge_values(learner)


@pytest.mark.rules('remapped', 'others-stay')
@pytest.mark.weight(2)
def test_remapped(learner):
    """robot2 publishes on /robot2/base/cmd_vel, robot1 on /robot1/cmd_vel; what they listen to stays.

    remappings=[('cmd_vel', 'base/cmd_vel')] for robot2, with relative names.
    """
    fleets.judge_names(learner)


@pytest.mark.rules('rate', 'max-linear', 'robot2', 'rest')
@pytest.mark.weight(2)
def test_another_robot(learner):
    """The parameter file is good for other robots, too: in any other namespace, rate 20 and max_linear 0.6.

    The name /** stands for all nodes in all namespaces.
    """
    number = learner.random.randint(3, 99)
    namespaces = f'/robot1{number}', f'/hall{number}/robot2', f'/robot1/deck{number}', f'/robot2/deck{number}'
    fleets.judge_others(learner, *namespaces)
