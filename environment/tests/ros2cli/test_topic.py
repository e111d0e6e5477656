"""`ros2 topic` and `ros2 node` beside a real node."""

import re
import subprocess

import pytest

from environment.tests.running import PATIENCE, ROS2

STRING_HASH = 'RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18'


@pytest.fixture(scope='module', autouse=True)
def robot(node):
    """The node that all tests of this module look at."""
    return node('robot')


def test_list(ros2):
    types = {
        '/chatter': 'std_msgs/msg/String',
        '/heard': 'std_msgs/msg/String',
        '/joints': 'sensor_msgs/msg/JointState',
        '/latched': 'std_msgs/msg/String',
        '/parameter_events': 'rcl_interfaces/msg/ParameterEvent',
        '/rosout': 'rcl_interfaces/msg/Log',
        '/sensor': 'std_msgs/msg/String',
        '/twist': 'geometry_msgs/msg/TwistStamped',
    }
    assert ros2.lines('topic', 'list') == list(types)
    assert ros2.lines('topic', 'list', '-t') == [f'{name} [{kind}]' for name, kind in types.items()]
    assert ros2.output('topic', 'list', '--count-topics') == f'{len(types)}\n'
    hidden = ros2.lines('topic', 'list', '--include-hidden-topics')
    assert hidden == ros2.lines('topic', '--include-hidden-topics', 'list') == ['/_hidden', *types]


def test_list_verbose(ros2):
    lines = ros2.lines('topic', 'list', '--verbose')
    assert lines[0] == 'Published topics:'
    assert ' * /chatter [std_msgs/msg/String] 1 publisher' in lines
    assert ' * /rosout [rcl_interfaces/msg/Log] 2 publishers' in lines  # the command itself has one
    assert lines[-4:] == ['', 'Subscribed topics:', ' * /heard [std_msgs/msg/String] 1 subscriber', '']


def test_info(ros2):
    assert ros2.output('topic', 'info', '/chatter') == (
        'Type: std_msgs/msg/String\nPublisher count: 1\nSubscription count: 0\n')
    assert ros2.error('topic', 'info', '/nothing') == "Unknown topic '/nothing'"


def test_info_verbose_shows_each_endpoint(ros2):
    text = ros2.output('topic', 'info', '/latched', '--verbose')
    gid = re.search(r'^GID: ([0-9a-f]{2}\.)+[0-9a-f]{2}$', text, re.MULTILINE)
    assert gid, text
    assert text.replace(gid.group(), 'GID: x') == (
        'Type: std_msgs/msg/String\n\n'
        'Publisher count: 1\n\n'
        'Node name: robot\n'
        'Node namespace: /\n'
        'Topic type: std_msgs/msg/String\n'
        f'Topic type hash: {STRING_HASH}\n'
        'Endpoint type: PUBLISHER\n'
        'GID: x\n'
        'QoS profile:\n'
        '  Reliability: RELIABLE\n'
        '  History (Depth): UNKNOWN\n'
        '  Durability: TRANSIENT_LOCAL\n'
        '  Lifespan: Infinite\n'
        '  Deadline: Infinite\n'
        '  Liveliness: AUTOMATIC\n'
        '  Liveliness lease duration: Infinite\n\n'
        'Subscription count: 0\n\n')


def test_type_and_find(ros2):
    assert ros2.output('topic', 'type', '/chatter') == 'std_msgs/msg/String\n'
    assert ros2.error('topic', 'type', '/nothing') == ''
    assert ros2.error('topic', 'type', '/_hidden') == ''
    assert ros2.output('topic', '--include-hidden-topics', 'type', '/_hidden') == 'std_msgs/msg/String\n'
    assert ros2.lines('topic', 'find', 'geometry_msgs/msg/TwistStamped') == ['/twist']
    assert ros2.lines('topic', 'find', 'std_msgs/msg/String', '-c') == ['4']
    assert ros2.lines('topic', 'find', 'std_msgs/msg/Nothing') == []


def test_echo_once(ros2):
    assert ros2.output('topic', 'echo', '--once', '/chatter') == 'data: hello\n---\n'
    assert ros2.output('topic', 'echo', '--once', 'chatter', 'std_msgs/msg/String') == 'data: hello\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--flow-style') == '{data: hello}\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--csv') == 'hello\n'
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--no-str') == "data: '<string length: <5>>'\n---\n"
    assert ros2.output('topic', 'echo', '--once', '/chatter', '-l', '2') == 'data: he...\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--raw').startswith("b'\\x00\\x01\\x00\\x00")


def test_echo_hears_every_quality_of_service(ros2):
    assert ros2.output('topic', 'echo', '--once', '/latched') == 'data: kept\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/sensor') == 'data: measured\n---\n'
    deaf = ros2.run('topic', 'echo', '--timeout', '1', '/sensor', '--qos-reliability', 'reliable')
    assert (deaf.returncode, deaf.stdout) == (0, '')
    assert "incompatible QoS" in deaf.stderr  # rclpy's warning
    assert ros2.output('topic', 'echo', '--timeout', '1', '/latched', '--qos-durability', 'volatile') == ''


def test_echo_a_field(ros2):
    assert ros2.output('topic', 'echo', '--once', '/twist', '--field', 'twist.linear') == (
        'x: 1.0\ny: 0.0\nz: 0.0\n---\n')
    assert ros2.output('topic', 'echo', '--once', '/twist', '--field', 'twist.linear.x') == '1.0\n---\n'
    assert ros2.output('topic', 'echo', '--once', '/joints', '--field', 'name') == "['left', 'right']\n---\n"
    assert ros2.error('topic', 'echo', '/chatter', '--field', 'date') == (
        "Invalid field 'date': 'String' object has no attribute 'date'")
    assert ros2.error('topic', 'echo', '/chatter', '--field', '.') == "Invalid field value '.'"


def test_echo_arrays(ros2):
    text = ros2.output('topic', 'echo', '--once', '/joints', '--no-arr')
    assert text.endswith(
        "name: '<sequence type: string, length: 2>'\nposition: '<sequence type: double, length: 2>'\n"
        "velocity: '<sequence type: double, length: 0>'\neffort: '<sequence type: double, length: 0>'\n---\n")
    assert ros2.output('topic', 'echo', '--once', '/joints', '-l', '1').endswith(
        "name:\n- l...\n- '...'\nposition:\n- 0.5\n- '...'\nvelocity: []\neffort: []\n---\n")


def test_echo_filters_and_tells_about_the_message(ros2):
    assert ros2.output('topic', 'echo', '--once', '/chatter', '--filter', "m.data == 'hello'") == 'data: hello\n---\n'
    assert ros2.output('topic', 'echo', '--timeout', '1', '/chatter', '--filter', "m.data == 'bye'") == ''
    assert ros2.error('topic', 'echo', '/chatter', '--filter', 'm.') == 'Invalid filter expression: invalid syntax'
    text = ros2.output('topic', 'echo', '--once', '-i', '/chatter')
    assert re.fullmatch(
        r'publication_sequence_number: \d+\nreceived_timestamp: \d+\nreception_sequence_number: (null|\d+)\n'
        r'source_timestamp: \d+\n---\ndata: hello\n---\n', text)


def test_echo_of_what_is_not_there(ros2):
    done = ros2.run('topic', 'echo', '/nothing')
    assert (done.returncode, done.stdout, done.stderr) == (
        1, 'WARNING: topic [/nothing] does not appear to be published yet\n',
        'Could not determine the type for the passed topic\n')
    for kind in ('std_msgs/msg/Nothing', 'no_such/msg/String', 'String', 'std_srvs/srv/Empty', '/'):
        assert ros2.error('topic', 'echo', '/chatter', kind) == 'The passed message type is invalid'
    assert 'topic name' in ros2.error('topic', 'echo', '/no way', 'std_msgs/msg/String')


def test_echo_ends_quietly_with_ctrl_c_and_with_its_reader(ros2):
    with ros2.start('topic', 'echo', '/chatter') as echo:
        echo.wait_for_output('data: hello', timeout=PATIENCE)
        echo.stop()
        assert set(echo.lines) == {'data: hello', '---'}
        assert echo.returncode == 2  # as stock: the number of SIGINT
    done = subprocess.run(
        ['bash', '-c', f'{ROS2} topic echo /chatter | head -1; echo ${{PIPESTATUS[0]}}'],
        capture_output=True, text=True, env=ros2.environ, timeout=2 * PATIENCE)
    assert (done.stdout, done.stderr) == ('data: hello\n141\n', '')


def test_pub_reaches_the_subscriber(ros2, robot):
    lines = ros2.lines('topic', 'pub', '--once', '/heard', 'std_msgs/msg/String', '{data: one}')
    assert [line for line in lines if not line.startswith('Waiting for at least 1 ')] == [
        'publisher: beginning loop', "publishing #1: std_msgs.msg.String(data='one')", '']
    robot.wait_for_output('heard one', timeout=PATIENCE)
    lines = ros2.lines('topic', 'pub', '-t', '3', '-r', '20', '-p', '2', '/heard', 'std_msgs/String', 'data: two')
    assert [line for line in lines if line.startswith('pub')] == [
        'publisher: beginning loop', "publishing #2: std_msgs.msg.String(data='two')"]
    robot.wait_for_output('heard two', timeout=PATIENCE)
    ros2.output('topic', 'pub', '-1', '--stdin', '/heard', 'std_msgs/msg/String', stdin='data: three')
    robot.wait_for_output('heard three', timeout=PATIENCE)


def test_pub_stamps(ros2):
    for values, kind in (('{stamp: now}', 'std_msgs/msg/Header'), ('{header: auto}', 'geometry_msgs/msg/PointStamped')):
        text = ros2.output('topic', 'pub', '-1', '-w', '0', '/stamped', kind, values)
        assert int(re.search(r'Time\(sec=(\d+)', text).group(1)) > 1_700_000_000


def test_pub_and_echo_with_a_chosen_quality_of_service(ros2):
    with ros2.start('topic', 'pub', '/kept', 'std_msgs/msg/Int32', '{data: 7}', '-r', '0.01',
                    '--qos-durability', 'transient_local') as pub:
        pub.wait_for_output('publishing #1', timeout=PATIENCE)
        assert ros2.output('topic', 'echo', '--once', '/kept') == 'data: 7\n---\n'


@pytest.mark.parametrize('values,message', [
    ('{data: [}', 'The passed value is not valid YAML: expected the node content, but found \'}\' (line 1, column 9)'),
    ('hello', 'The passed value needs to be a dictionary in YAML format'),
    ('[1, 2]', 'The passed value needs to be a dictionary in YAML format'),
    ('{date: 1}', "Failed to populate field: 'Int32' object has no attribute 'date'"),
    ('{data: {a: 1}}', "Failed to populate field: int() argument must be a string, a bytes-like object or a real "
                       "number, not 'dict'"),
    ('{data: many}', "Failed to populate field: invalid literal for int() with base 10: 'many'"),
    ('{off: 1}', "Failed to populate field: Field name 'False' is expected to be a string but is a bool"),
])
def test_pub_refuses_bad_values(ros2, values, message):
    assert ros2.error('topic', 'pub', '-1', '-w', '0', '/x', 'std_msgs/msg/Int32', values) == message


def test_pub_refuses_other_bad_input(ros2):
    assert ros2.error('topic', 'pub', '-1', '/x', 'std_msgs/msg/Nothing') == 'The passed message type is invalid'
    assert 'field must be an integer' in ros2.error(
        'topic', 'pub', '-1', '-w', '0', '/x', 'std_msgs/msg/Int32', '{data: 3000000000}')
    assert "topic name '/1x' is invalid" in ros2.error('topic', 'pub', '-1', '/1x', 'std_msgs/msg/Int32')
    assert 'Invalid node name' in ros2.error('topic', 'pub', '-1', '-n', 'no way', '/x', 'std_msgs/msg/Int32')
    assert 'not allowed with' in ros2.error('topic', 'pub', '-1', '-t', '2', '/x', 'std_msgs/msg/Int32', status=2)
    assert 'value must be positive' in ros2.error(
        'topic', 'pub', '-r', '0', '/x', 'std_msgs/msg/Int32', status=2)
    assert ros2.error(
        'topic', 'pub', '-1', '-w', '2', '--max-wait-time-secs', '0.5', '/x', 'std_msgs/msg/Int32') == (
        'Timed out waiting for subscribers: Expected 2 subcribers but only got 0 subscribers')


NUMBER = r'-?\d+\.\d'


@pytest.mark.parametrize('argv,lines', [
    (['hz', '/chatter'], [r'average rate: \d+\.\d{3}',
                          rf'\tmin: {NUMBER}{{3}}s max: {NUMBER}{{3}}s std dev: {NUMBER}{{5}}s window: \d+']),
    (['delay', '/twist'], [rf'average delay: {NUMBER}{{3}}',
                           rf'\tmin: {NUMBER}{{3}}s max: {NUMBER}{{3}}s std dev: {NUMBER}{{5}}s window: \d+']),
    (['bw', '/chatter'], [r'Subscribed to \[/chatter\]', r'\d+ B/s from \d+ messages',
                          r'\tMessage size mean: 16 B min: 16 B max: 16 B']),
])
def test_measuring(ros2, argv, lines):
    with ros2.start('topic', *argv) as meter:
        meter.wait_for_output(r'min: ', timeout=PATIENCE)
        meter.stop()
        assert meter.returncode == 2
    for line, pattern in zip(meter.lines, lines, strict=False):
        assert re.fullmatch(pattern, line), meter.lines


def test_measuring_waits_for_the_topic(ros2):
    with ros2.start('topic', 'hz', '/later') as meter:
        meter.wait_for_output('WARNING: topic [/later] does not appear to be published yet', timeout=PATIENCE)
        with ros2.start('topic', 'pub', '/later', 'std_msgs/msg/Empty', '-r', '20'):
            meter.wait_for_output('average rate: ', timeout=PATIENCE)


def test_delay_needs_a_header(ros2):
    assert ros2.error('topic', 'delay', '/chatter') == 'msg does not have header'


def test_node_list(ros2):
    assert ros2.lines('node', 'list') == ['/robot']
    assert ros2.output('node', 'list', '-c') == '1\n'
    everything = ros2.lines('node', 'list', '--all')
    assert everything[-1] == '/robot'
    assert re.fullmatch(r'/_ros2cli_\d+', everything[0])


def test_node_info(ros2):
    services = ''.join(
        f'    /robot/{name}: rcl_interfaces/srv/{kind}\n' if kind != 'GetTypeDescription' else
        f'    /robot/{name}: type_description_interfaces/srv/{kind}\n'
        for name, kind in (
            ('describe_parameters', 'DescribeParameters'), ('get_parameter_types', 'GetParameterTypes'),
            ('get_parameters', 'GetParameters'), ('get_type_description', 'GetTypeDescription'),
            ('list_parameters', 'ListParameters'), ('set_parameters', 'SetParameters'),
            ('set_parameters_atomically', 'SetParametersAtomically')))
    assert ros2.output('node', 'info', '/robot') == (
        '/robot\n'
        '  Subscribers:\n'
        '    /heard: std_msgs/msg/String\n'
        '  Publishers:\n'
        '    /chatter: std_msgs/msg/String\n'
        '    /joints: sensor_msgs/msg/JointState\n'
        '    /latched: std_msgs/msg/String\n'
        '    /parameter_events: rcl_interfaces/msg/ParameterEvent\n'
        '    /rosout: rcl_interfaces/msg/Log\n'
        '    /sensor: std_msgs/msg/String\n'
        '    /twist: geometry_msgs/msg/TwistStamped\n'
        '  Service Servers:\n'
        f'{services}'
        '    /switch: std_srvs/srv/SetBool\n'
        '  Service Clients:\n'
        '\n'
        '  Action Servers:\n'
        '\n'
        '  Action Clients:\n'
        '\n')
    assert '    /_hidden: std_msgs/msg/String' in ros2.lines('node', 'info', 'robot', '--include-hidden')
    assert ros2.error('node', 'info', '/nobody') == "Unable to find node '/nobody'"


def test_a_fixed_time_for_discovery_is_kept(ros2):
    assert ros2.output('topic', 'list', '--spin-time', '0.1', '--no-daemon', '-s').startswith('/')
    assert 'invalid float value' in ros2.error('topic', 'list', '--spin-time', 'long', status=2)
