"""`ros2 action` beside real nodes."""

import re

import pytest

from environment.tests.running import PATIENCE

pytestmark = pytest.mark.usefixtures('several_nodes')

FIBONACCI = ('action', 'send_goal', '/fibonacci', 'example_interfaces/action/Fibonacci')


def test_action_list_info_type(ros2):
    kind = 'example_interfaces/action/Fibonacci'
    assert ros2.lines('action', 'list') == ['/fibonacci']
    assert ros2.lines('action', 'list', '-t') == [f'/fibonacci [{kind}]']
    assert ros2.lines('action', 'list', '-c') == ['1']
    assert ros2.output('action', 'type', '/fibonacci') == f'{kind}\n'
    assert ros2.error('action', 'type', '/nothing') == ''
    assert ros2.output('action', 'info', '/fibonacci', '-t') == (
        f'Action: /fibonacci\nAction clients: 0\nAction servers: 1\n    /worker [{kind}]\n'
    )
    assert ros2.output('action', 'info', '/fibonacci', '-c') == (
        'Action: /fibonacci\nAction clients: 0\nAction servers: 1\n'
    )
    assert 'topic name' in ros2.error('action', 'info', '/no way')


def test_send_goal(ros2):
    text = ros2.output(*FIBONACCI, '{order: 3}', '--feedback')
    identifier = re.search('Goal accepted with ID: ([0-9a-f]{32})\n', text).group(1)
    assert text.startswith(
        'Waiting for an action server to become available...\nSending goal:\n     order: 3\n\n'
        f'Goal accepted with ID: {identifier}\n\nFeedback:\n    sequence:\n'
    )
    assert 'Feedback:\n    sequence:\n- 0\n- 1\n- 1\n- 2\n\n' in text
    assert text.endswith('Result:\n    sequence:\n- 0\n- 1\n- 1\n- 2\n\nGoal finished with status: SUCCEEDED\n')


def test_ctrl_c_cancels_the_goal(ros2):
    with ros2.start(*FIBONACCI, '{order: 40}', '-f') as goal:
        goal.wait_for_output('Feedback:', timeout=PATIENCE)
        goal.stop(timeout=PATIENCE)
        assert goal.lines.index('Canceling goal...') < goal.lines.index('Goal canceled.')
        assert goal.returncode == 2


def test_send_goal_waits_as_long_as_asked(ros2):
    nothing = ('action', 'send_goal', '/nothing', 'example_interfaces/action/Fibonacci', '{}')
    done = ros2.run(*nothing, '--timeout', '0.5')
    assert done.returncode == 1
    assert done.stdout == 'Waiting for an action server to become available...\n'
    assert done.stderr == 'Action server is not available after waiting 0.5 seconds.\n'
    done = ros2.run(*FIBONACCI, '{order: 40}', '--timeout', '0.5')
    assert done.returncode == 1
    # A busy machine may need longer to find the server, or to cancel the goal.
    assert 'after waiting 0.5 seconds.' in done.stderr or 'Failed to cancel goal' in done.stderr
    assert 'Goal accepted' not in done.stdout or 'Canceling goal...' in done.stdout
    assert 'Goal finished' not in done.stdout


def test_send_goal_refuses_bad_input(ros2):
    assert ros2.lines(*FIBONACCI, '{order: 41}')[-1] == 'Goal was rejected.'
    assert ros2.error(*FIBONACCI[:3], 'example_interfaces/action/Nothing') == 'The passed action type is invalid'
    assert ros2.error(*FIBONACCI, '{ordr: 1}') == (
        "Failed to populate message fields: AttributeError(\"'Fibonacci_Goal' object has no attribute 'ordr'\")"
    )
    assert ros2.error(*FIBONACCI, '{order: ').startswith('The passed value is not valid YAML: ')
    assert 'must be an integer' in ros2.error(*FIBONACCI, '{order: 9999999999}')
