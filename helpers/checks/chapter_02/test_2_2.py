"""Visible tests of exercise 2.2, repair a package."""

import pytest

from helpers.checks.chapter_02 import builds
from helpers.runner import expect

pytestmark = pytest.mark.exercise('2.2')


def test_program_is_found(learner):
    """`ros2 run` finds the program follow of line_follower.

    It looks into the folder lib/line_follower of the installation. Which file says where programs go?
    """
    installed = builds.line_follower(learner).installed()
    programs = [name for name in installed if name.endswith('/follow')]
    expect(programs, 'No program `follow` is installed: look at entry_points.')
    expect('line_follower/lib/line_follower/follow' in programs,
           f'The program is installed as {programs[0]}; `ros2 run` looks for it in lib/line_follower. Compare '
           'setup.cfg with the one that `ros2 pkg create` makes.')


def test_it_drives(learner):
    """`ros2 run line_follower follow` prints `forward 0.20 m/s, turn -0.08 rad/s`.

    This works only after several faults are repaired. Read the last line of the error, repair, and go on.
    """
    done = builds.line_follower(learner).run('ros2', 'run', 'line_follower', 'follow')
    expect(done.last_line == 'forward 0.20 m/s, turn -0.08 rad/s',
           f'`ros2 run line_follower follow` ended with: {done.last_line}')
