"""Visible tests of exercise 8.10, start it."""

import pytest

from helpers.checks.chapter_08 import deliveries
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.10')


def test_arguments(learner):
    """The package can be built and read, and its launch file has the arguments scene and real_time_factor.

    The cells of exercises 8.5 and 8.7 to 8.9 run without an error; DeclareLaunchArgument(name, default_value=…).
    """
    workspace = deliveries.workspace(learner)
    done = workspace.run('python3', '-c', 'import delivery_robot.main')
    expect(done.status == 0, f'Python cannot read your package, with your cells of exercises 8.5 and 8.7 to 8.9 in it: '
                             f'{done.last_line}')
    done = workspace.run('ros2', 'launch', 'delivery_robot', 'delivery.launch.py', '--show-args')
    expect(done.status == 0, f'ros2 launch cannot read your launch file: {done.last_line}')
    for name, default in (('scene', 'rooms'), ('real_time_factor', '1.0')):
        expect(f"'{name}'" in done.output, f'The launch file has no argument {name}.')
        told = done.output.partition(f"'{name}'")[2].partition("':")[0]
        expect(f"default: '{default}'" in told, f'The default of {name} is not {default}.')
