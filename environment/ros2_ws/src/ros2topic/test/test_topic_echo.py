"""`ros2 topic echo` beside a real node."""

import re
import subprocess

import pytest

from environment.tests.running import PATIENCE, ROS2

pytestmark = pytest.mark.usefixtures('robot')


def test_echo_once(ros2):
    assert ros2.output('topic', 'echo', '--once', '/chatter') == 'data: hello\n---\n'
    assert ros2.output('topic', 'echo', '--once', 'chatter', 'std_msgs/msg/String') == 'data: hello\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--flow-style') == 'data: hello\n---\n'
    assert 'position: [0.5, 1.5]\n' in ros2.output('topic', 'echo', '--once', '/joints', '--flow-style')
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--csv') == 'hello\n'
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--no-str') == "data: '<string length: <5>>'\n---\n"
    assert ros2.output('topic', 'echo', '--once', '/chatter', '-l', '2') == 'data: he...\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--raw').startswith("b'\\x00\\x01\\x00\\x00")


def test_echo_hears_every_quality_of_service(ros2):
    assert ros2.output('topic', 'echo', '--once', '/latched') == 'data: kept\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/sensor') == 'data: measured\n---\n'
    deaf = ros2.run('topic', 'echo', '--timeout', '1', '/sensor', '--qos-reliability', 'reliable')
    assert (deaf.returncode, deaf.stdout) == (0, '')
    assert 'incompatible QoS' in deaf.stderr  # rclpy's warning
    assert ros2.output('topic', 'echo', '--timeout', '1', '/latched', '--qos-durability', 'volatile') == ''


def test_echo_a_field(ros2):
    assert ros2.output('topic', 'echo', '--once', '/twist', '--field', 'twist.linear') == (
        'x: 1.0\ny: 0.0\nz: 0.0\n---\n'
    )
    assert ros2.output('topic', 'echo', '--once', '/twist', '--field', 'twist.linear.x') == '1.0\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/joints', '--field', 'name') == "['left', 'right']\n---\n"
    assert ros2.error('topic', 'echo', '/chatter', '--field', 'date') == (
        "Invalid field 'date': 'String' object has no attribute 'date'"
    )
    assert ros2.error('topic', 'echo', '/chatter', '--field', '.') == "Invalid field value '.'"


def test_echo_arrays(ros2):
    text = ros2.output('topic', 'echo', '--once', '/joints', '--no-arr')
    assert text.endswith(
        "name: '<sequence type: string, length: 2>'\nposition: '<sequence type: double, length: 2>'\n"
        "velocity: '<sequence type: double, length: 0>'\neffort: '<sequence type: double, length: 0>'\n---\n"
    )
    assert ros2.output('topic', 'echo', '--once', '/joints', '-l', '1').endswith(
        "name:\n- l...\n- '...'\nposition:\n- 0.5\n- '...'\nvelocity: []\neffort: []\n---\n"
    )


def test_echo_filters_and_tells_about_the_message(ros2):
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--filter', "m.data == 'hello'") == 'data: hello\n---\n'
    assert ros2.output('topic', 'echo', '--timeout', '1', '/chatter', '--filter', "m.data == 'bye'") == ''
    assert ros2.error('topic', 'echo', '/chatter', '--filter', 'm.') == 'Invalid filter expression: invalid syntax'
    text = ros2.output('topic', 'echo', '--once', '-i', '/chatter')
    assert re.fullmatch(
        r'publication_sequence_number: \d+\nreceived_timestamp: \d+\nreception_sequence_number: (null|\d+)\n'
        r'source_timestamp: \d+\n---\ndata: hello\n---\n',
        text,
    )


def test_echo_of_what_is_not_there(ros2):
    done = ros2.run('topic', 'echo', '/nothing')
    assert (done.returncode, done.stdout, done.stderr) == (
        1,
        'WARNING: topic [/nothing] does not appear to be published yet\n',
        'Could not determine the type for the passed topic\n',
    )
    for kind in ('std_msgs/msg/Nothing', 'no_such/msg/String', 'String', 'std_srvs/srv/Empty', '/'):
        assert ros2.error('topic', 'echo', '/chatter', kind) == 'The passed message type is invalid'
    assert 'topic name' in ros2.error('topic', 'echo', '/no way', 'std_msgs/msg/String')


def test_echo_ends_quietly_with_ctrl_c_and_with_its_reader(ros2):
    with ros2.start('topic', 'echo', '/chatter') as echo:
        echo.wait_for_output('data: hello', timeout=PATIENCE)
        echo.stop(PATIENCE)
        assert set(echo.lines) == {'data: hello', '---'}
        assert echo.returncode == 2  # as stock: the number of SIGINT
    done = subprocess.run(
        ['bash', '-c', f'{ROS2} topic echo /chatter | head -1; echo ${{PIPESTATUS[0]}}'],
        capture_output=True,
        text=True,
        env=ros2.environ,
        timeout=2 * PATIENCE,
    )
    assert (done.stdout, done.stderr) == ('data: hello\n141\n', '')
