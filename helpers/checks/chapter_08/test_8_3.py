"""Visible tests of exercise 8.3, two governors."""

import pytest

from helpers.checks.chapter_08 import fleets
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('8.3')
ROBOTS = ('/robot1/governor', '/robot2/governor')
WANTED = {  # name of the node → parameter → (value, rule)
    ROBOTS[0]: {'rate': (20.0, 'rate'), 'max_linear': (1.0, 'robot1'), 'mode': ('normal', 'robot2')},
    ROBOTS[1]: {'rate': (20.0, 'rate'), 'max_linear': (0.6, 'max-linear'), 'mode': ('slow', 'robot2')},
}


def robots(learner) -> dict[str, dict]:
    """What the two governors report."""
    with about('nodes'):
        there = fleets.launched(learner)
    expect(
        set(there) == set(ROBOTS),
        f'These nodes were started: {", ".join(sorted(there))}; expected {" and ".join(ROBOTS)}.',
        'nodes',
    )
    return there


@pytest.mark.rules('nodes', 'types')
def test_two_robots(learner):
    """`ros2 launch` starts the nodes /robot1/governor and /robot2/governor, and no others.

    One Node(…) for each robot, with its namespace.
    """
    robots(learner)


@pytest.mark.rules('robot1', 'robot2')
def test_values(learner):
    """robot1 has max_linear 1 and the mode normal; robot2 has max_linear 0.6 and the mode slow; both have the rate 20.

    A later block of the file overrides an earlier one: the block for all comes first.
    """
    there = robots(learner)
    for name, parameters in WANTED.items():
        for parameter, (wanted, rule) in parameters.items():
            got = there[name][parameter]
            expect(
                got == wanted,
                f'{name} has {parameter} = {got!r}, expected {wanted!r}. Does it get the file, does '
                'the name of the block fit, and does a later block override it?',
                rule,
            )


@pytest.mark.rules('remapped', 'others-stay')
def test_names(learner):
    """robot2 publishes on /robot2/base/cmd_vel, robot1 on /robot1/cmd_vel; what they listen to stays.

    remappings=[('cmd_vel', 'base/cmd_vel')] for robot2, with relative names.
    """
    there = robots(learner)
    for name, wanted, rule in (
        (ROBOTS[1], '/robot2/base/cmd_vel', 'remapped'),
        (ROBOTS[0], '/robot1/cmd_vel', 'others-stay'),
    ):
        got = there[name]['publishes']
        expect(
            got == wanted, f'{name} publishes on {got}, expected {wanted}. Names in remappings are relative, too.', rule
        )
    for name in ROBOTS:
        got, wanted = there[name]['listens'], name.replace('governor', 'cmd_vel_in')
        expect(got == wanted, f'{name} listens to {got}, expected {wanted}.', 'others-stay')


@pytest.mark.rules('rate', 'max-linear')
def test_another_robot(learner):
    """The parameter file is good for a third robot, too: in any other namespace, rate 20 and max_linear 0.6.

    The name /** stands for all nodes in all namespaces.
    """
    robots(learner)
    number = learner.random.randint(3, 99)
    for namespace in (f'/robot{number}', f'/hall{number}/robot1'):
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
def test_installed_file(learner):
    """The values come from the installed file: who changes that file changes the robots.

    In the launch file, parameters= is a list with the path of the installed file.
    """
    robots(learner)
    drawn = learner.random.randint(21, 49)
    found = [report['rate'] for report in fleets.launched_with_rate(learner, drawn)]
    expect(
        found == [drawn, drawn],
        f'The rate in the installed config/fleet.yaml was changed to {drawn}, and the '
        f'governors have {found}. The launch file must use the installed file, for both, '
        'and give no values itself.',
    )
