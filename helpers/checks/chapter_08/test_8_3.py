"""Visible tests of exercise 8.3, two governors."""

import pytest

from helpers.checks.chapter_08 import fleets

pytestmark = pytest.mark.exercise('8.3')


@pytest.mark.rules('nodes', 'types')
def test_two_robots(learner):
    """`ros2 launch` starts the nodes /robot1/governor and /robot2/governor, and no others.

    One Node(…) for each robot, with its namespace.
    """
    fleets.robots(learner)


@pytest.mark.rules('robot1', 'robot2', 'rest')
def test_values(learner):
    """robot1 has max_linear 1 and the mode normal; robot2 has max_linear 0.6 and the mode slow; both have the rate 20.

    A later block of the file overrides an earlier one: the block for all comes first.
    """
    fleets.judge_values(learner)


@pytest.mark.rules('remapped', 'others-stay')
def test_names(learner):
    """robot2 publishes on /robot2/base/cmd_vel, robot1 on /robot1/cmd_vel; what they listen to stays.

    remappings=[('cmd_vel', 'base/cmd_vel')] for robot2, with relative names.
    """
    fleets.judge_names(learner)


@pytest.mark.rules('rate', 'max-linear', 'robot2', 'rest')
def test_another_robot(learner):
    """The parameter file is good for a third robot, too: in any other namespace, rate 20 and max_linear 0.6.

    The name /** stands for all nodes in all namespaces.
    """
    number = learner.random.randint(3, 99)
    namespaces = [f'/hall{number}/robot1', f'/hall{number}/robot2', f'/robot1/deck{number}', f'/robot2/deck{number}']
    fleets.judge_others(learner, f'/robot{number}', *namespaces)


@pytest.mark.rules('installed-file')
def test_installed_file(learner):
    """The values come from the installed file: who changes that file changes the robots.

    In the launch file, parameters= is a list with the path of the installed file.
    """
    fleets.judge_installed_file(learner)
