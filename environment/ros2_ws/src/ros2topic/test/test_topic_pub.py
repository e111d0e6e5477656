"""`ros2 topic pub` beside a real node."""

import re

import pytest

from environment.tests.running import PATIENCE

pytestmark = pytest.mark.usefixtures('robot')


def test_pub_reaches_the_subscriber(ros2, robot):
    lines = ros2.lines('topic', 'pub', '--once', '/heard', 'std_msgs/msg/String', '{data: one}')
    assert [line for line in lines if not line.startswith('Waiting for at least 1 ')] == [
        'publisher: beginning loop',
        "publishing #1: std_msgs.msg.String(data='one')",
        '',
    ]
    robot.wait_for_output('heard one', timeout=PATIENCE)
    lines = ros2.lines('topic', 'pub', '-t', '3', '-r', '20', '-p', '2', '/heard', 'std_msgs/String', 'data: two')
    assert [line for line in lines if line.startswith('pub')] == [
        'publisher: beginning loop',
        "publishing #2: std_msgs.msg.String(data='two')",
    ]
    robot.wait_for_output('heard two', timeout=PATIENCE)
    ros2.output('topic', 'pub', '-1', '--stdin', '/heard', 'std_msgs/msg/String', stdin='data: three')
    robot.wait_for_output('heard three', timeout=PATIENCE)


def test_pub_stamps(ros2):
    for values, kind in (('{stamp: now}', 'std_msgs/msg/Header'), ('{header: auto}', 'geometry_msgs/msg/PointStamped')):
        text = ros2.output('topic', 'pub', '-1', '-w', '0', '/stamped', kind, values)
        assert int(re.search(r'Time\(sec=(\d+)', text).group(1)) > 1_700_000_000


def test_pub_and_echo_with_a_chosen_quality_of_service(ros2):
    with ros2.start(
        'topic', 'pub', '/kept', 'std_msgs/msg/Int32', '{data: 7}', '-r', '0.01', '--qos-durability', 'transient_local'
    ) as pub:
        pub.wait_for_output('publishing #1', timeout=PATIENCE)
        assert ros2.output('topic', 'echo', '--once', '/kept') == 'data: 7\n---\n'


@pytest.mark.parametrize(
    'values,message',
    [
        (
            '{data: [}',
            "The passed value is not valid YAML: expected the node content, but found '}' (line 1, column 9)",
        ),
        ('hello', 'The passed value needs to be a dictionary in YAML format'),
        ('[1, 2]', 'The passed value needs to be a dictionary in YAML format'),
        ('{date: 1}', "Failed to populate field: 'Int32' object has no attribute 'date'"),
        (
            '{data: {a: 1}}',
            'Failed to populate field: int() argument must be a string, a bytes-like object or a real '
            "number, not 'dict'",
        ),
        ('{data: many}', "Failed to populate field: invalid literal for int() with base 10: 'many'"),
        ('{off: 1}', "Failed to populate field: Field name 'False' is expected to be a string but is a bool"),
    ],
)
def test_pub_refuses_bad_values(ros2, values, message):
    assert ros2.error('topic', 'pub', '-1', '-w', '0', '/x', 'std_msgs/msg/Int32', values) == message


def test_pub_refuses_other_bad_input(ros2):
    assert ros2.error('topic', 'pub', '-1', '/x', 'std_msgs/msg/Nothing') == 'The passed message type is invalid'
    assert 'field must be an integer' in ros2.error(
        'topic', 'pub', '-1', '-w', '0', '/x', 'std_msgs/msg/Int32', '{data: 3000000000}'
    )
    assert "topic name '/1x' is invalid" in ros2.error('topic', 'pub', '-1', '/1x', 'std_msgs/msg/Int32')
    assert 'Invalid node name' in ros2.error('topic', 'pub', '-1', '-n', 'no way', '/x', 'std_msgs/msg/Int32')
    assert 'not allowed with' in ros2.error('topic', 'pub', '-1', '-t', '2', '/x', 'std_msgs/msg/Int32', status=2)
    assert 'value must be positive' in ros2.error('topic', 'pub', '-r', '0', '/x', 'std_msgs/msg/Int32', status=2)
    assert ros2.error('topic', 'pub', '-1', '-w', '2', '--max-wait-time-secs', '0.5', '/x', 'std_msgs/msg/Int32') == (
        'Timed out waiting for subscribers: Expected 2 subcribers but only got 0 subscribers'
    )


@pytest.mark.parametrize('count', [['--once'], ['-t', '3']])
def test_waiting_for_a_subscriber_has_an_end(ros2, count):
    done = ros2.run('topic', 'pub', *count, '--max-wait-time-secs', '0.5', '/unheard', 'std_msgs/msg/Int32')
    assert done.returncode == 1
    assert 'Timed out waiting for subscribers: Expected 1 subcribers but only got 0' in done.stderr
    assert 'only effective with' in ros2.error(
        'topic', 'pub', '--max-wait-time-secs', '1', '/unheard', 'std_msgs/msg/Int32'
    )


def test_upstreams_names_of_the_api():
    from rclpy.qos import QoSProfile, QoSReliabilityPolicy
    from ros2topic.api import profile_configure_short_keys, qos_profile_from_short_keys

    assert qos_profile_from_short_keys('sensor_data', reliability='reliable', depth=3).depth == 3
    profile = QoSProfile(depth=1)
    profile_configure_short_keys(profile, reliability='best_effort')
    assert profile.reliability == QoSReliabilityPolicy.BEST_EFFORT
