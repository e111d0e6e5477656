"""Visible tests of exercise 2.4, a library and its user."""

import pytest

from helpers.checks.chapter_02 import builds
from helpers.runner import expect

pytestmark = pytest.mark.exercise('2.4')


def test_both_are_built(learner):
    """`colcon build --packages-up-to odometry` builds wheel_math, too.

    colcon knows what odometry needs only from its package.xml.
    """
    done = builds.odometry(learner).build('--packages-up-to', 'odometry')
    expect('Finished <<< wheel_math' in done.output,
           'Only odometry was built. Its package.xml does not say that it needs wheel_math.')


def test_report(learner):
    """`ros2 run odometry report 360` prints `0.207 m`.

    import distance from wheel_math.geometry, and take the ticks from sys.argv.
    """
    done = builds.odometry(learner).run('ros2', 'run', 'odometry', 'report', '360')
    expect(done.last_line == '0.207 m', f'`ros2 run odometry report 360` ended with: {done.last_line}')
