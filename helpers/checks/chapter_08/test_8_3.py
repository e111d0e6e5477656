"""Visible tests of exercise 8.3, two governors."""

import pytest

from helpers.checks.chapter_08 import fleets
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.3')


def test_two_robots(learner):
    """`ros2 launch` starts the nodes /robot1/governor and /robot2/governor, and no others.

    One Node(…) for each robot, with its namespace.
    """
    there = sorted(fleets.launched(learner))
    expect(there == ['/robot1/governor', '/robot2/governor'],
           f'These nodes were started: {", ".join(there)}; expected /robot1/governor and /robot2/governor.')


def test_rate(learner):
    """Both governors have the rate 20 from the parameter file.

    parameters=[config] in each Node(…); the block /** in the file.
    """
    for name, report in fleets.launched(learner).items():
        expect(report['rate'] == 20.0, f'{name} has the rate {report["rate"]:g}, expected 20. Does each Node get the '
                                       'file, and does the block in it fit the name of the node?')
