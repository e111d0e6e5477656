"""`ros2 param` beside real nodes."""

import sys

import pytest

from environment.tests.running import PATIENCE
from helpers.programs.processes import background

pytestmark = pytest.mark.usefixtures('several_nodes')


def test_param_list(ros2):
    names = ['arm.joints', 'fixed', 'free', 'name', 'rate', 'start_type_description_service', 'use_sim_time']
    assert ros2.lines('param', 'list', '/robot') == [f'  {name}' for name in names]
    everything = ros2.lines('param', 'list')
    assert [line for line in everything if line.endswith(':')] == [
        '/adder:',
        '/managed:',
        '/plain:',
        '/robot:',
        '/worker:',
    ]
    assert ros2.lines('param', 'list', 'robot', '--param-type', '--filter', '^[afr]') == [
        '  arm.joints (type: double array)',
        '  fixed (type: boolean)',
        '  free (type: integer)',
        '  rate (type: integer)',
    ]
    # As stock: from the beginning of the name, and a node without such a parameter is not named.
    assert ros2.lines('param', 'list', '--filter', 'arm|oints|ame') == ['/robot:', '  arm.joints']
    assert ros2.lines('param', 'list', '/robot', '--filter', 'joints') == []
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
        'Parameter name: fixed\n  Type: boolean\n  Constraints:\n    Read only: true\n'
    )


def test_param_set(ros2):
    assert ros2.output('param', 'set', '/robot', 'free', '2') == 'Set parameter successful\n'
    assert ros2.output('param', 'get', '/robot', 'free') == 'Integer value is: 2\n'
    for value, text in (
        ('text', 'String value is: text'),
        ('[1, 2]', "Integer values are: array('q', [1, 2])"),
        ('1.5', 'Double value is: 1.5'),
        ('"3"', 'String value is: 3'),
    ):
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
        '/plain:\n  ros__parameters:\n    start_type_description_service: true\n    use_sim_time: false\n\n'
    )
    file = tmp_path / 'robot.yaml'
    file.write_text('/robot:\n  ros__parameters:\n    rate: 9\n    arm:\n      joints: [3.0]\n    fixed: false\n')
    done = ros2.run('param', 'load', '/robot', str(file))
    assert done.stdout == 'Set parameter rate successful\nSet parameter arm.joints successful\n'
    assert done.stderr == 'Set parameter fixed failed: Trying to set a read-only parameter: fixed.\n'
    assert '    arm:\n      joints:\n      - 3.0\n' in ros2.output('param', 'dump', '/robot')
    file.write_text('/**:\n  ros__parameters:\n    rate: 3\n')
    assert ros2.output('param', 'load', '/robot', str(file)) == 'Set parameter rate successful\n'
    assert ros2.error('param', 'load', '/robot', str(file), '--no-use-wildcard') == (
        "Param file does not contain parameters for /robot, only for nodes: ['/**']"
    )
    file.write_text('a: [')
    assert 'is not valid YAML' in ros2.error('param', 'load', '/robot', str(file))
    file.write_text('- 1')
    assert 'is not a valid ROS parameter file' in ros2.error('param', 'load', '/robot', str(file))
    assert 'No such file or directory' in ros2.error('param', 'load', '/robot', '/no/such/file')


def test_what_is_not_set_is_left_out_of_a_dump(ros2):
    code = (
        'import rclpy; from rclpy.parameter import Parameter; rclpy.init(); node = rclpy.create_node("half"); '
        'node.declare_parameter("unset", Parameter.Type.STRING); node.declare_parameter("rate", 2.0); '
        'print("ready", flush=True); rclpy.spin(node)'
    )
    with background([sys.executable, '-c', code], env=ros2.environ) as half:
        half.wait_for_output('ready', timeout=PATIENCE)
        dump = ros2.output('param', 'dump', '/half')
    assert '    rate: 2.0\n' in dump and 'unset' not in dump


def test_a_prefix_that_nothing_has_prints_nothing(ros2, robot):
    assert ros2.output('param', 'list', '--param-prefixes', 'no_such') == ''


def test_load_looks_for_the_node_first(ros2, robot):
    assert ros2.error('param', 'load', '/nobody', 'no_such.yaml') == 'Node not found'
    assert ros2.error('param', 'load', '/robot', 'no_such.yaml').startswith("Cannot read parameter file 'no_such.yaml'")


def test_the_type_of_a_text_is_guessed_as_by_set():
    from rcl_interfaces.msg import ParameterType
    from ros2param.api import get_parameter_value, get_value

    value = get_parameter_value(string_value='[1, 2]')
    assert (value.type, get_value(parameter_value=value)) == (ParameterType.PARAMETER_INTEGER_ARRAY, [1, 2])
    assert get_parameter_value(string_value='["open"').type == ParameterType.PARAMETER_STRING
