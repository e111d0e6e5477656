"""`ros2 topic list`, `info`, `type` and `find` beside a real node."""

import re

import pytest

pytestmark = pytest.mark.usefixtures('robot')

STRING_HASH = 'RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18'


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
        'Type: std_msgs/msg/String\nPublisher count: 1\nSubscription count: 0\n'
    )
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
        'Subscription count: 0\n\n'
    )


def test_type_and_find(ros2):
    assert ros2.output('topic', 'type', '/chatter') == 'std_msgs/msg/String\n'
    assert ros2.error('topic', 'type', '/nothing') == ''
    assert ros2.error('topic', 'type', '/_hidden') == ''
    assert ros2.output('topic', '--include-hidden-topics', 'type', '/_hidden') == 'std_msgs/msg/String\n'
    assert ros2.lines('topic', 'find', 'geometry_msgs/msg/TwistStamped') == ['/twist']
    assert ros2.lines('topic', 'find', 'std_msgs/msg/String', '-c') == ['4']
    assert ros2.lines('topic', 'find', 'std_msgs/msg/Nothing') == []


def test_a_fixed_time_for_discovery_is_kept(ros2):
    assert ros2.output('topic', 'list', '--spin-time', '0.1', '--no-daemon', '-s').startswith('/')
    assert 'invalid float value' in ros2.error('topic', 'list', '--spin-time', 'long', status=2)
