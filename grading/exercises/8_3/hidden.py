"""Hidden tests of exercise 8.3, two governors: in other namespaces, and with other values in the installed file."""

import pytest

from helpers.checks.chapter_08 import fleets
from helpers.checks.chapter_08.test_8_3 import ROBOTS, WANTED, robots
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('8.3')


@pytest.mark.rules('nodes', 'types', 'robot1', 'robot2', 'installed-file', 'max-linear')
@pytest.mark.weight(2)
def test_values(learner):
    """robot1 has max_linear 1 and the mode normal; robot2 has max_linear 0.6 and the mode slow; both have the rate 20.

    A later block of the file overrides an earlier one: the block for all comes first.
    """
    there = robots(learner)
    for name, parameters in WANTED.items():
        for parameter, (wanted, rule) in parameters.items():
            got = there[name][parameter]
            expect(got == wanted, f'{name} has {parameter} = {got!r}, expected {wanted!r}.', rule)


@pytest.mark.rules('remapped', 'others-stay')
@pytest.mark.weight(2)
def test_remapped(learner):
    """robot2 publishes on /robot2/base/cmd_vel, robot1 on /robot1/cmd_vel; what they listen to stays.

    remappings=[('cmd_vel', 'base/cmd_vel')] for robot2, with relative names.
    """
    first, second = (robots(learner)[name] for name in ROBOTS)
    for report, wanted, rule in (
        (second, '/robot2/base/cmd_vel', 'remapped'),
        (first, '/robot1/cmd_vel', 'others-stay'),
    ):
        expect(
            report['publishes'] == wanted,
            f'{report["node"]} publishes on {report["publishes"]}, expected {wanted}.',
            rule,
        )
        wanted = report['node'].replace('governor', 'cmd_vel_in')
        expect(
            report['listens'] == wanted,
            f'{report["node"]} listens to {report["listens"]}, expected {wanted}.',
            'others-stay',
        )


@pytest.mark.rules('rate', 'max-linear')
@pytest.mark.weight(2)
def test_another_robot(learner):
    """The parameter file is good for other robots, too: in any other namespace, rate 20 and max_linear 0.6.

    The name /** stands for all nodes in all namespaces.
    """
    robots(learner)
    number = learner.random.randint(3, 99)
    for namespace in (f'/robot1{number}', f'/hall{number}/robot2'):
        with about('rate'):
            report = fleets.alone(learner, namespace)
        for name, wanted, rule in (
            ('rate', 20.0, 'rate'),
            ('max_linear', 0.6, 'max-linear'),
            ('mode', 'normal', 'robot2'),
        ):
            expect(
                report[name] == wanted,
                f'A governor in {namespace} with your file has {name} = {report[name]!r}, expected {wanted!r}.',
                rule,
            )


@pytest.mark.rules('installed-file')
def test_no_values_in_the_launch_file(learner):
    """The values come from the file: who changes the file changes the robots.

    In the launch file, parameters= is a list with the path of the installed file.
    """
    robots(learner)
    drawn = learner.random.randint(21, 49)
    rates = [report for report in fleets.launched_with_rate(learner, drawn) if report['rate'] == drawn]
    expect(
        len(rates) == 2,
        f'The rate in the installed config/fleet.yaml was changed to {drawn}, and {len(rates)} of '
        'the two governors have it. The launch file must use the installed file, for both.',
    )
