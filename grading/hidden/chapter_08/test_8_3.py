"""Hidden tests of exercise 8.3, two governors."""

import pytest

from helpers.checks.chapter_08 import fleets
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.3')
ROBOTS = ('/robot1/governor', '/robot2/governor')


def robots(learner) -> list[dict]:
    there = fleets.launched(learner)
    expect(set(there) == set(ROBOTS), f'These nodes were started: {", ".join(sorted(there))}; expected '
                                      f'{" and ".join(ROBOTS)}.')
    return [there[name] for name in ROBOTS]


@pytest.mark.weight(2)
def test_values(learner):
    """robot1 has max_linear 1 and the mode normal; robot2 has max_linear 0.6 and the mode slow; both have the rate 20.

    A later block of the file overrides an earlier one: the block for all comes first.
    """
    for report, wanted in zip(robots(learner), ({'rate': 20.0, 'max_linear': 1.0, 'mode': 'normal'},
                                                {'rate': 20.0, 'max_linear': 0.6, 'mode': 'slow'}), strict=True):
        got = {name: report[name] for name in wanted}
        expect(got == wanted, f'{report["node"]} has {got}, expected {wanted}. Does it get the file, does the name of '
                              'the block fit, and does a later block override it?')


@pytest.mark.weight(2)
def test_remapped(learner):
    """robot2 publishes on /robot2/base/cmd_vel, robot1 on /robot1/cmd_vel; what they listen to stays.

    remappings=[('cmd_vel', 'base/cmd_vel')] for robot2, with relative names.
    """
    first, second = robots(learner)
    for report, wanted in ((first, '/robot1/cmd_vel'), (second, '/robot2/base/cmd_vel')):
        expect(report['publishes'] == wanted, f'{report["node"]} publishes on {report["publishes"]}, expected '
                                              f'{wanted}. Names in remappings are relative, too.')
        wanted = report['node'].replace('governor', 'cmd_vel_in')
        expect(report['listens'] == wanted, f'{report["node"]} listens to {report["listens"]}, expected {wanted}.')


@pytest.mark.weight(2)
def test_another_robot(learner):
    """The parameter file is good for a third robot, too: in any other namespace, rate 20 and max_linear 0.6.

    The name /** stands for all nodes in all namespaces.
    """
    number = learner.random.randint(3, 99)
    report = fleets.alone(learner, f'/robot{number}')
    got = {name: report[name] for name in ('rate', 'max_linear', 'mode')}
    wanted = {'rate': 20.0, 'max_linear': 0.6, 'mode': 'normal'}
    expect(got == wanted, f'A governor in /robot{number} with your file has {got}, expected {wanted}.')
    nested = fleets.alone(learner, f'/hall{number}/robot1')
    expect(nested['rate'] == 20.0 and nested['max_linear'] == 0.6,
           f'A governor in /hall{number}/robot1 has rate {nested["rate"]:g} and max_linear {nested["max_linear"]:g}, '
           'expected 20 and 0.6: it is not the one in /robot1.')


def test_no_values_in_the_launch_file(learner):
    """The values come from the file: who changes the file changes the robots.

    In the launch file, parameters= is a list with the path of the installed file.
    """
    workspace = fleets.fleet(learner)
    drawn = learner.random.randint(21, 49)
    share = '$(ros2 pkg prefix --share fleet)'
    done = workspace.run(
        'bash', '-c', f'cd {share}; cp config/fleet.yaml kept.yaml; rm -f changed.txt\n'
        f'sed -i "s/20[.]0*/{drawn}.0/" config/fleet.yaml\n'
        'FLEET_REPORT=$PWD/changed.txt ros2 launch fleet fleet.launch.py > /dev/null 2>&1\n'
        'cp kept.yaml config/fleet.yaml; cat changed.txt')
    rates = [line for line in done.lines if f'"rate": {drawn}.0' in line]
    expect(len(rates) == 2, f'The rate in the installed config/fleet.yaml was changed to {drawn}, and {len(rates)} of '
                            'the two governors have it. The launch file must use the installed file, for both.')
