"""Visible tests of exercise 7.1, a machine."""

import pytest

from helpers.checks.chapter_07 import machines
from helpers.checks.chapter_07.findings import compare
from helpers.runner import expect

pytestmark = pytest.mark.exercise('7.1')


def test_not_sourced(learner):
    """A line that sources ROS and is a comment does nothing: one finding, of row A7.2.

    `active(text)` gives the lines that do something.
    """
    files = {'ros2.list': 'deb [signed-by=/key.gpg] http://packages.ros.org/ros2/ubuntu noble main\n',
             '.bashrc': '# source /opt/ros/jazzy/setup.bash\n'}
    got = learner.call('diagnose_machine', files, {'distro': 'jazzy', 'codename': 'noble', 'domain': 0})
    compare(got, [('A7.2', '.bashrc', 'not sourced', '')], machines.WHY)


def test_two_distributions(learner):
    """A machine that sources two distributions is found, and repaired.

    Each line that sources another distribution is a finding; its evidence is the line.
    """
    files, want, expected = machines.draw(learner.random, 'other')
    compare(learner.call('diagnose_machine', files, want), expected, machines.WHY)
    repaired = learner.call('repair_machine', files, want)
    expect(repaired != files, 'repair_machine changed nothing.')
    machines.try_out(learner, files, repaired, want)
