"""What is told of the output of a launch: the line that names the error, and what to do about it."""

import pytest

from helpers.checks.chapter_08 import launch_output

CAUGHT = '[ERROR] [launch]: Caught exception in launch (see debug for traceback): '
DIED = "[ERROR] [robot-1]: process has died [pid 7, exit code 1, cmd 'robot']."


@pytest.mark.parametrize(
    ('log', 'told'),
    [
        ('', 'nothing'),
        ('[INFO] [launch]: All log files are in /tmp\n[INFO] [world-1]: started', '[INFO] [world-1]: started'),
        (f'ValueError: no such station\n{DIED}\n', 'ValueError: no such station'),
        (f"{CAUGHT}executable 'robo' not found\n[INFO] [world-1]: the end", f"{CAUGHT}executable 'robo' not found"),
        (
            "- NameError: name 'Node' is not defined\n- InvalidFrontendLaunchFileError: it may have a syntax error",
            "NameError: name 'Node' is not defined. Write: from launch_ros.actions import Node",
        ),
        (
            "- NameError: name 'LaunchConfiguration' is not defined",
            "NameError: name 'LaunchConfiguration' is not defined. "
            'Write: from launch.substitutions import LaunchConfiguration',
        ),
        ("- NameError: name 'confg' is not defined", "NameError: name 'confg' is not defined"),
        (
            f"{CAUGHT}launch configuration 'scene' does not exist",
            f"{CAUGHT}launch configuration 'scene' does not exist. Declare each argument before the action that needs "
            'its value.',
        ),
        (
            f'{CAUGHT}too many values to unpack (expected 2)',
            f'{CAUGHT}too many values to unpack (expected 2). Arguments and remappings are pairs: of a dictionary give '
            'its items().',
        ),
        (
            "- TypeError: Node.__init__() got an unexpected keyword argument 'package'",
            "TypeError: Node.__init__() got an unexpected keyword argument 'package'. This is the Node of rclpy. In a "
            'launch file write: from launch_ros.actions import Node',
        ),
    ],
)
def test_the_line_that_tells_most(log, told):
    assert launch_output.telling(log) == told


@pytest.mark.parametrize(
    ('log', 'missing'),
    [
        (
            'Parameter file path is not a file: /ws/install/fleet/share/fleet/configfleet.yaml',
            '…/share/fleet/configfleet.yaml',
        ),
        ('RuntimeError: Error opening YAML file, at ./src/parser.c:270', 'a file'),
        ('all is well', ''),
    ],
)
def test_a_parameter_file_that_is_not_there(log, missing):
    assert launch_output.missing_parameter_file(log) == missing
