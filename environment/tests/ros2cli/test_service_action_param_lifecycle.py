"""`ros2 service`, `action`, `param` and `lifecycle` beside real nodes."""

import re

import pytest

from environment.tests.running import PATIENCE

SWITCH = ('service', 'call', '/switch', 'std_srvs/srv/SetBool')
FIBONACCI = ('action', 'send_goal', '/fibonacci', 'example_interfaces/action/Fibonacci')


@pytest.fixture(scope='module', autouse=True)
def nodes(node):
    """The nodes that the tests of this module look at."""
    for name in ('robot', 'worker', 'managed', 'adder'):
        node(name)


def test_service_list_type_find_info(ros2):
    assert '/switch' in ros2.lines('service', 'list')
    assert '/switch [std_srvs/srv/SetBool]' in ros2.lines('service', 'list', '-t')
    assert not [name for name in ros2.lines('service', 'list') if '_action' in name]
    assert '/fibonacci/_action/send_goal' in ros2.lines('service', 'list', '--include-hidden-services')
    assert ros2.output('service', 'type', '/switch') == 'std_srvs/srv/SetBool\n'
    assert ros2.error('service', 'type', '/nothing') == ''
    assert ros2.lines('service', 'find', 'std_srvs/srv/SetBool') == ['/switch']
    assert ros2.lines('service', 'find', 'std_srvs/srv/SetBool', '-c') == ['1']
    assert ros2.output('service', 'info', '/switch') == (
        'Type: std_srvs/srv/SetBool\nClients count: 0\nServices count: 1\n')


def test_service_call_of_the_article(ros2):
    text = ros2.output('service', 'call', '/add_two_ints', 'example_interfaces/srv/AddTwoInts', '{a: 10, b: 20}')
    assert text.removeprefix('waiting for service to become available...\n') == (
        'requester: making request: example_interfaces.srv.AddTwoInts_Request(a=10, b=20)\n\n'
        'response:\nexample_interfaces.srv.AddTwoInts_Response(sum=30)\n\n')


def test_service_call_waits_for_the_server_and_repeats(ros2):
    with ros2.start(*SWITCH[:2], '/nobody', SWITCH[3]) as call:
        call.wait_for_output('waiting for service to become available...', timeout=PATIENCE)
        call.stop()
        assert call.lines == ['waiting for service to become available...']
        assert call.returncode == 2
    with ros2.start(*SWITCH, '{data: true}', '-r', '20') as call:
        for _ in range(2):
            call.wait_for_output("message='switched'", timeout=PATIENCE)


def test_service_call_refuses_bad_input(ros2):
    assert ros2.error(*SWITCH[:3], 'std_srvs/srv/Nothing') == 'The passed service type is invalid'
    assert ros2.error(*SWITCH[:3], 'SetBool') == 'The passed service type is invalid'
    assert ros2.error(*SWITCH[:3], 'std_msgs/msg/String') == 'The passed type is not a service'
    assert ros2.error(*SWITCH, '{date: 1}') == (
        "Failed to populate field: 'SetBool_Request' object has no attribute 'date'")
    assert ros2.error(*SWITCH, '{data: [').startswith('The passed value is not valid YAML: ')
    assert ros2.error(*SWITCH, 'yes') == 'The passed value needs to be a dictionary in YAML format'
    assert ros2.error(*SWITCH, '-r', '0') == 'rate must be greater than zero'
    assert 'service name' in ros2.error(*SWITCH[:2], '/no way', SWITCH[3])


def test_action_list_info_type(ros2):
    kind = 'example_interfaces/action/Fibonacci'
    assert ros2.lines('action', 'list') == ['/fibonacci']
    assert ros2.lines('action', 'list', '-t') == [f'/fibonacci [{kind}]']
    assert ros2.lines('action', 'list', '-c') == ['1']
    assert ros2.output('action', 'type', '/fibonacci') == f'{kind}\n'
    assert ros2.error('action', 'type', '/nothing') == ''
    assert ros2.output('action', 'info', '/fibonacci', '-t') == (
        f'Action: /fibonacci\nAction clients: 0\nAction servers: 1\n    /worker [{kind}]\n')
    assert ros2.output('action', 'info', '/fibonacci', '-c') == (
        'Action: /fibonacci\nAction clients: 0\nAction servers: 1\n')
    assert 'topic name' in ros2.error('action', 'info', '/no way')


def test_send_goal(ros2):
    text = ros2.output(*FIBONACCI, '{order: 3}', '--feedback')
    identifier = re.search('Goal accepted with ID: ([0-9a-f]{32})\n', text).group(1)
    assert text.startswith(
        'Waiting for an action server to become available...\nSending goal:\n     order: 3\n\n'
        f'Goal accepted with ID: {identifier}\n\nFeedback:\n    sequence:\n')
    assert 'Feedback:\n    sequence:\n- 0\n- 1\n- 1\n- 2\n\n' in text
    assert text.endswith(
        'Result:\n    sequence:\n- 0\n- 1\n- 1\n- 2\n\nGoal finished with status: SUCCEEDED\n')


def test_ctrl_c_cancels_the_goal(ros2):
    with ros2.start(*FIBONACCI, '{order: 40}', '-f') as goal:
        goal.wait_for_output('Feedback:', timeout=PATIENCE)
        goal.stop(timeout=PATIENCE)
        assert goal.lines.index('Canceling goal...') < goal.lines.index('Goal canceled.')
        assert goal.returncode == 2


def test_send_goal_refuses_bad_input(ros2):
    assert ros2.lines(*FIBONACCI, '{order: 41}')[-1] == 'Goal was rejected.'
    assert ros2.error(*FIBONACCI[:3], 'example_interfaces/action/Nothing') == 'The passed action type is invalid'
    assert ros2.error(*FIBONACCI, '{ordr: 1}') == (
        'Failed to populate message fields: AttributeError("\'Fibonacci_Goal\' object has no attribute \'ordr\'")')
    assert ros2.error(*FIBONACCI, '{order: ').startswith('The passed value is not valid YAML: ')
    assert 'must be an integer' in ros2.error(*FIBONACCI, '{order: 9999999999}')


def test_param_list(ros2):
    names = ['arm.joints', 'fixed', 'free', 'name', 'rate', 'start_type_description_service', 'use_sim_time']
    assert ros2.lines('param', 'list', '/robot') == [f'  {name}' for name in names]
    everything = ros2.lines('param', 'list')
    assert [line for line in everything if line.endswith(':')] == [
        '/adder:', '/managed:', '/plain:', '/robot:', '/worker:']
    assert ros2.lines('param', 'list', 'robot', '--param-type', '--filter', '^[afr]') == [
        '  arm.joints (type: double array)', '  fixed (type: boolean)', '  free (type: integer)',
        '  rate (type: integer)']
    assert ros2.lines('param', 'list', '/robot', '--param-prefixes', 'arm') == ['  arm.joints']
    assert ros2.error('param', 'list', '/nobody') == 'Node not found'
    assert ros2.error('param', 'list', '--filter', '[').startswith("Invalid regular expression '['")


def test_param_get_and_describe(ros2):
    assert ros2.output('param', 'get', '/robot', 'name') == 'String value is: bob\n'
    assert ros2.output('param', 'get', 'robot', 'fixed') == 'Boolean value is: True\n'
    assert ros2.output('param', 'get', '/robot', 'arm.joints') == "Double values are: array('d', [1.0, 2.0])\n"
    assert ros2.output('param', 'get', '/robot', 'name', '--hide-type') == 'bob\n'
    assert ros2.error('param', 'get', '/robot', 'nothing') == 'Parameter not set'
    assert ros2.error('param', 'get', '/nobody', 'name') == 'Node not found'
    assert ros2.output('param', 'describe', '/robot', 'rate', 'fixed') == (
        'Parameter name: rate\n  Type: integer\n  Description: How often\n  Constraints:\n'
        '    Min value: 1\n    Max value: 10\n    Step: 1\n'
        'Parameter name: fixed\n  Type: boolean\n  Constraints:\n    Read only: true\n')


def test_param_set(ros2):
    assert ros2.output('param', 'set', '/robot', 'free', '2') == 'Set parameter successful\n'
    assert ros2.output('param', 'get', '/robot', 'free') == 'Integer value is: 2\n'
    for value, text in (('text', 'String value is: text'), ('[1, 2]', "Integer values are: array('q', [1, 2])"),
                        ('1.5', 'Double value is: 1.5'), ('"3"', 'String value is: 3')):
        ros2.output('param', 'set', '/robot', 'free', value)
        assert ros2.output('param', 'get', '/robot', 'free') == f'{text}\n'
    done = ros2.run('param', 'set', '/robot', 'rate', '70')
    assert done.stderr == 'Setting parameter failed: Parameter rate out of range. Min: 1, Max: 10, value: 70\n'
    done = ros2.run('param', 'set', '/robot', 'fixed', 'false')
    assert done.stderr == 'Setting parameter failed: Trying to set a read-only parameter: fixed.\n'
    assert ros2.error('param', 'set', '/nobody', 'x', '1') == 'Node not found'
    assert 'invalid' in ros2.error('param', 'set', '/robot', 'free', '99999999999999999999')
    assert ros2.run('param', 'delete', '/robot', 'name').stderr.startswith('Deleting parameter failed')
    assert ros2.output('param', 'delete', '/robot', 'free') == 'Deleted parameter successfully\n'
    assert ros2.error('param', 'get', '/robot', 'free') == 'Parameter not set'


def test_param_dump_and_load(ros2, tmp_path):
    dump = ros2.output('param', 'dump', '/plain')
    assert dump == (
        '/plain:\n  ros__parameters:\n    start_type_description_service: true\n    use_sim_time: false\n\n')
    file = tmp_path / 'robot.yaml'
    file.write_text('/robot:\n  ros__parameters:\n    rate: 9\n    arm:\n      joints: [3.0]\n    fixed: false\n')
    done = ros2.run('param', 'load', '/robot', str(file))
    assert done.stdout == 'Set parameter rate successful\nSet parameter arm.joints successful\n'
    assert done.stderr == 'Set parameter fixed failed: Trying to set a read-only parameter: fixed.\n'
    assert '    arm:\n      joints:\n      - 3.0\n' in ros2.output('param', 'dump', '/robot')
    file.write_text('/**:\n  ros__parameters:\n    rate: 3\n')
    assert ros2.output('param', 'load', '/robot', str(file)) == 'Set parameter rate successful\n'
    assert ros2.error('param', 'load', '/robot', str(file), '--no-use-wildcard') == (
        "Param file does not contain parameters for /robot, only for nodes: ['/**']")
    file.write_text('a: [')
    assert 'is not valid YAML' in ros2.error('param', 'load', '/robot', str(file))
    file.write_text('- 1')
    assert 'is not a valid ROS parameter file' in ros2.error('param', 'load', '/robot', str(file))
    assert 'No such file or directory' in ros2.error('param', 'load', '/robot', '/no/such/file')


def test_lifecycle(ros2):
    assert ros2.lines('lifecycle', 'nodes') == ['/managed']
    assert ros2.lines('lifecycle', 'nodes', '-c') == ['1']
    assert ros2.output('lifecycle', 'get') == '/managed: unconfigured [1]\n'
    assert ros2.output('lifecycle', 'list', '/managed') == (
        '- configure [1]\n\tStart: unconfigured\n\tGoal: configuring\n'
        '- shutdown [5]\n\tStart: unconfigured\n\tGoal: shuttingdown\n')
    assert ros2.error('lifecycle', 'set', '/managed', 'fly') == (
        'Unknown transition requested, available ones are:\n- configure [1]\n- shutdown [5]')
    assert ros2.output('lifecycle', 'set', '/managed', 'configure') == 'Transitioning successful\n'
    assert ros2.output('lifecycle', 'get', 'managed') == 'inactive [2]\n'
    assert ros2.output('lifecycle', 'set', '/managed', '3') == 'Transitioning successful\n'
    assert ros2.output('lifecycle', 'get', '/managed') == 'active [3]\n'
    assert '- cleanup [2]' in ros2.lines('lifecycle', 'list', '/managed', '--all')
    for verb in (('get', '/plain'), ('list', '/nobody'), ('set', '/plain', 'configure')):
        assert ros2.error('lifecycle', *verb) == 'Node not found'
