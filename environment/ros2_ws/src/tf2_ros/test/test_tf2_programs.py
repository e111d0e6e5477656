"""The programs, run as a user runs them: their output, line by line, and their exit status."""

import math
import re
import threading
import xml.etree.ElementTree as ElementTree

import pytest
import tf2_ros
import yaml
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_ros_executables.static_transform_publisher import USAGE, Arguments, ArgumentsError, parse
from tf2_ros_executables.tf2_echo import describe
from tf2_ros_executables.tf2_monitor import Delays
from tf2_tools import graph, view_frames

from environment.tests.running import ended
from environment.tests.tf2_domain import TIMEOUT
from environment.tests.tf2_messages import position, transform

LATEST = Time()
LONG = Duration(seconds=TIMEOUT)
HALF = math.sqrt(0.5)


@pytest.fixture
def heard(domain):
    """A buffer that hears what is sent in the domain."""
    node = domain.node('hearing')
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, node)
    domain.spin(node)
    return buffer


def test_static_transform_publisher_by_position(domain, heard):
    publisher = domain.program('tf2_ros', 'static_transform_publisher', *'1.0 0.0 0.5 0 0 0 world robot_base'.split())
    publisher.wait_for_output("from 'world' to 'robot_base'", TIMEOUT)
    assert publisher.lines[0] == '[WARN] []: Old-style arguments are deprecated; see --help for new-style arguments'
    assert re.fullmatch(
        r'\[INFO\] \[static_transform_publisher_[0-9A-Za-z]{16}\]: '
        'Spinning until stopped - publishing transform',
        publisher.lines[1],
    )
    assert publisher.lines[2:5] == [
        "translation: ('1.000000', '0.000000', '0.500000')",
        "rotation: ('0.000000', '0.000000', '0.000000', '1.000000')",
        "from 'world' to 'robot_base'",
    ]
    assert position(heard.lookup_transform('world', 'robot_base', LATEST, LONG)) == (1.0, 0.0, 0.5)
    assert publisher.stop(TIMEOUT) == 0
    assert 'Traceback' not in publisher.output


def test_static_transform_publisher_by_flags(domain, heard):
    publisher = domain.program(
        'tf2_ros',
        'static_transform_publisher',
        '--x',
        '1',
        '--yaw',
        '1.5707963267948966',
        '--frame-id',
        'world',
        '--child-frame-id',
        'base',
        '--ros-args',
        '-r',
        '__node:=here',
    )
    publisher.wait_for_output('[INFO] [here]: Spinning until stopped - publishing transform', TIMEOUT)
    publisher.wait_for_output("rotation: ('0.000000', '0.000000', '0.707107', '0.707107')", TIMEOUT)
    found = heard.lookup_transform('world', 'base', LATEST, LONG)
    assert (found.transform.rotation.z, found.transform.rotation.w) == pytest.approx((HALF, HALF))


def test_help(domain):
    assert ended(domain.program('tf2_ros', 'static_transform_publisher', '--help')) == (0, USAGE)


@pytest.mark.parametrize(
    ('words', 'complaint'),
    [
        ('', 'Frame id must not be empty'),
        ('--x 1 --frame-id a --child-frame-id', 'Not enough arguments for --child-frame-id'),
        ('--x one --frame-id a --child-frame-id b', 'Failed to parse --x argument as float'),
        ('1 2 z 0 0 0 a b', 'Failed to parse z argument as float'),
        ('1 2 3 0 0 a b', 'Extra unparsed arguments on command-line'),
        ('--what --frame-id a --child-frame-id b', 'Extra unparsed arguments on command-line'),
        ('--roll 1 --qx 1 --frame-id a --child-frame-id b', 'Cannot specify both quaternion and Euler rotations'),
        ('1 2 3 0 0 0 a b --frame-id c', 'Cannot specify both new-style (flags) and old-style (arguments)'),
        ('--frame-id a', 'Child frame id must not be empty'),
    ],
)
def test_command_lines_without_sense(words, complaint):
    with pytest.raises(ArgumentsError) as caught:
        parse(words.split())
    assert str(caught.value) == complaint


@pytest.mark.parametrize(
    ('words', 'translation', 'rotation'),
    [
        ('1 2 3 1.5707963267948966 0 0 a b', [1, 2, 3], [0, 0, HALF, HALF]),
        ('1 2 3 0 0 3.141592653589793 a b', [1, 2, 3], [1, 0, 0, 0]),
        ('1 2 3 .5 .5 .5 .5 a b', [1, 2, 3], [0.5, 0.5, 0.5, 0.5]),
        ('--z -1e-1 --qz 1 --qw 0 --frame-id a --child-frame-id b', [0, 0, -0.1], [0, 0, 1, 0]),
        ('--pitch 1.5707963267948966 --child-frame-id b --frame-id a', [0, 0, 0], [0, HALF, 0, HALF]),
        ('--frame-id a --child-frame-id b', [0, 0, 0], [0, 0, 0, 1]),
        ('--x 1.5m --frame-id a --child-frame-id b', [1.5, 0, 0], [0, 0, 0, 1]),
    ],
)
def test_command_lines_with_sense(words, translation, rotation):
    arguments = parse(words.split())
    assert arguments == Arguments(pytest.approx(translation), pytest.approx(rotation, abs=1e-12), 'a', 'b')


def test_static_transform_publisher_refuses(domain):
    status, output = ended(domain.program('tf2_ros', 'static_transform_publisher', '1', '2', '3'))
    assert status == 1
    assert output == (
        '[ERROR] []: error parsing command line arguments: Extra unparsed arguments on command-line\n' + USAGE
    )
    status, output = ended(domain.program('tf2_ros', 'static_transform_publisher', *'0 0 0 0 0 0 a a'.split()))
    assert status == 1
    assert "]: cannot publish static transform from 'a' to 'a', exiting" in output and 'Traceback' not in output


def test_nonsense_that_can_be_sent_is_refused_by_the_receiver(domain):
    echo = domain.program('tf2_ros', 'tf2_echo', 'a', 'b', '20')
    echo.wait_for_output(
        '[INFO] [tf2_echo]: Waiting for transform a ->  b: Invalid frame ID "a" passed to '
        'canTransform argument target_frame - frame does not exist',
        TIMEOUT,
    )
    domain.program('tf2_ros', 'static_transform_publisher', '--x', 'nan', '--frame-id', 'a', '--child-frame-id', 'b')
    echo.wait_for_output(
        '[ERROR] []: TF_NAN_INPUT: Ignoring transform for child_frame_id "b" from authority '
        '"default_authority" because of a nan value in the transform '
        '(nan 0.000000 0.000000) (0.000000 0.000000 0.000000 1.000000)',
        TIMEOUT,
    )
    domain.program('tf2_ros', 'static_transform_publisher', '--z', '1', '--frame-id', 'a', '--child-frame-id', 'b')
    echo.wait_for_output('At time 0.0', TIMEOUT)
    echo.wait_for_output('  0.000  0.000  0.000  1.000', TIMEOUT)
    first = echo.lines.index('At time 0.0')
    assert echo.lines[first : first + 10] == [
        'At time 0.0',
        '- Translation: [0.000, 0.000, 1.000]',
        '- Rotation: in Quaternion [0.000, 0.000, 0.000, 1.000]',
        '- Rotation: in RPY (radian) [0.000, -0.000, 0.000]',
        '- Rotation: in RPY (degree) [0.000, -0.000, 0.000]',
        '- Matrix:',
        '  1.000  0.000  0.000  0.000',
        '  0.000  1.000  0.000  0.000',
        '  0.000  0.000  1.000  1.000',
        '  0.000  0.000  0.000  1.000',
    ]
    assert echo.stop(TIMEOUT) == 0
    assert 'Traceback' not in echo.output


def test_echo_ends_quietly_when_its_reader_has_had_enough(domain):
    domain.program('tf2_ros', 'static_transform_publisher', '--frame-id', 'a', '--child-frame-id', 'b')
    echo = domain.start(['sh', '-c', 'ros2 run tf2_ros tf2_echo a b 20 | grep -m 1 "At time"'])
    assert ended(echo)[0] == 0
    assert 'At time 0.0' in echo.lines
    assert not any(word in echo.output for word in ('Broken pipe', 'Errno', 'Traceback'))


def test_echo_of_frames_that_loop(domain):
    for parent, child in ('ab', 'ba', 'xy'):
        domain.program('tf2_ros', 'static_transform_publisher', '--frame-id', parent, '--child-frame-id', child)
    echo = domain.program('tf2_ros', 'tf2_echo', 'y', 'a', '20')
    echo.wait_for_output('Waiting for transform y ->  a: The tf tree is invalid because it contains a loop.', TIMEOUT)
    assert echo.stop(TIMEOUT) == 0
    assert 'Traceback' not in echo.output


@pytest.mark.parametrize(
    ('words', 'status', 'output'),
    [
        ([], 1, 'Usage: tf2_echo source_frame target_frame [echo_rate]\n\n'),
        (['a', 'b', 'fast'], 2, "Failed to convert rate argument 'fast' to a floating-point number"),
        (['a', 'b', '1.0x'], 3, "Failed to convert rate argument '1.0x' to a floating-point number"),
        (['a', 'b', '-1'], 1, 'rate must be greater than 0'),
        (['a', 'b', '--ros-args', '-p', 'nonsense'], 1, "Couldn't parse params file"),
    ],
)
def test_echo_refuses(domain, words, status, output):
    its_status, its_output = ended(domain.program('tf2_ros', 'tf2_echo', *words))
    assert its_status == status
    assert output.split('params')[0] in its_output and 'Traceback' not in its_output


@pytest.mark.parametrize(
    ('xyzw', 'angles'),
    [
        ((0, 0, HALF, HALF), '[0.000, -0.000, 90.000]'),
        ((0, HALF, 0, HALF), '[0.000, 90.000, 0.000]'),
        ((HALF, 0, 0, HALF), '[90.000, -0.000, 0.000]'),
    ],
)
def test_description_of_angles(xyzw, angles):
    lines = describe(transform('a', 'b', 2.000000005, (1, 2, 3), xyzw)).splitlines()
    assert lines[0] == 'At time 2.5'
    assert lines[4] == f'- Rotation: in RPY (degree) {angles}'


def test_monitor_begins(domain):
    monitor = domain.program('tf2_ros', 'tf2_monitor')
    monitor.wait_for_output('Gathering data on all frames for 10 seconds...', TIMEOUT)
    assert monitor.stop(TIMEOUT) == 0
    waiting = domain.program('tf2_ros', 'tf2_monitor', 'a', 'b')
    waiting.wait_for_output('Waiting for transform a ->  b: Invalid frame ID "a" passed to canTransform', TIMEOUT)
    domain.program('tf2_ros', 'static_transform_publisher', '--frame-id', 'a', '--child-frame-id', 'b')
    waiting.wait_for_output('Gathering data on a -> b for 10 seconds...', TIMEOUT)
    assert waiting.stop(TIMEOUT) == 0
    assert ended(domain.program('tf2_ros', 'tf2_monitor', 'a')) == (255, 'TF_Monitor: usage: tf2_monitor framea frameb')


def test_monitor_reports():
    delays = Delays()
    assert delays.report() == '\n\n\nRESULTS: for all Frames\n\nFrames:\n\nAll Broadcasters:'
    delays.receive(TFMessage(transforms=[transform('a', 'b', 9.5), transform('b', 'c', 9.0)]), now=10.0)
    delays.receive(TFMessage(transforms=[transform('a', 'b', 10.0)]), now=11.0)
    delays.sample_chain(Time(seconds=9).to_msg(), now=10.0)
    no_one = '<no authority available>'
    assert delays.report().splitlines() == [
        '',
        '',
        '',
        'RESULTS: for all Frames',
        '',
        'Frames:',
        f'Frame: b, published by {no_one}, Average Delay: 0.75, Max Delay: 1',
        f'Frame: c, published by {no_one}, Average Delay: 1, Max Delay: 1',
        '',
        'All Broadcasters:',
        f'Node: {no_one} 2 Hz, Average Delay: 0.875 Max Delay: 1',
    ]
    assert delays.report(['b', 'a']).splitlines()[3:8] == [
        'RESULTS: for b to a',
        'Chain is: b -> a',
        'Net delay     avg = 0.01: max = 1',
        '',
        'Frames:',
    ]


def test_picture_of_the_frames(tmp_path, monkeypatch):
    buffer = tf2_ros.BufferCore()
    for parent, child in (('map', 'odom'), ('odom', 'base <&>'), ('base <&>', 'laser'), ('base <&>', 'camera')):
        buffer.set_transform(transform(parent, child, 1.0), 'test')
    text = buffer.all_frames_as_yaml()
    monkeypatch.setattr(view_frames.shutil, 'which', lambda _: None)
    picture = view_frames.write(tmp_path / 'frames', text, (12, 500_000_000))
    assert picture == tmp_path / 'frames.svg'
    assert (tmp_path / 'frames.yaml').read_text() == text
    dot = (tmp_path / 'frames.gv').read_text()
    assert '"map" -> "odom"[label=" Broadcaster: test\\nAverage rate: 10000.0\\nBuffer length: 0.0\\n' in dot
    assert '"Recorded at time: 12.5"[ shape=plaintext ] ;\n}->"map";\n}' in dot
    words = [element.text for element in ElementTree.parse(picture).iter('{http://www.w3.org/2000/svg}text')]
    assert {'map', 'odom', 'base <&>', 'laser', 'camera'} <= set(words)
    places = graph._layout(yaml.safe_load(text))
    assert len(set(places.values())) == 5 and places['map'][1] == 0 and places['laser'][1] == 3


def test_picture_with_graphviz(tmp_path, monkeypatch):
    fake = tmp_path / 'dot'
    fake.write_text('#!/bin/sh\ncp "$2" "$4"\n')
    fake.chmod(0o755)
    monkeypatch.setenv('PATH', str(tmp_path), prepend=':')
    assert view_frames.write(tmp_path / 'frames', '[]', (0, 0)) == tmp_path / 'frames.pdf'
    assert 'No tf data received' in (tmp_path / 'frames.pdf').read_text()


@pytest.mark.parametrize('text', ['[]', "a: \n  parent: 'b'\nb: \n  parent: 'a'\n"])
def test_picture_of_nothing_and_of_a_loop(text):
    data = (
        {}
        if text == '[]'
        else {
            name: {
                **entry,
                'broadcaster': 'x',
                'rate': 1.0,
                'buffer_length': 0.0,
                'most_recent_transform': 1.0,
                'oldest_transform': 1.0,
            }
            for name, entry in yaml.safe_load(text).items()
        }
    )
    assert graph.generate_dot(data, (0, 0)).startswith('digraph G {')
    ElementTree.fromstring(graph.generate_svg(data, (0, 0)))


def test_view_frames(domain, tmp_path):
    domain.program('tf2_ros', 'static_transform_publisher', '--frame-id', 'a', '--child-frame-id', 'b')
    program = domain.program('tf2_tools', 'view_frames', '-o', tmp_path / 'tree')
    status, output = ended(program)
    assert status == 0, output
    assert output.startswith(
        '[INFO] [view_frames]: Listening to tf data for 5.0 seconds...\n'
        '[INFO] [view_frames]: Generating graph...\n'
        '[INFO] [view_frames]: Result:tf2_msgs.srv.FrameGraph_Response(frame_yaml="b: \\n'
    )
    assert yaml.safe_load((tmp_path / 'tree.yaml').read_text())['b']['parent'] == 'a'
    assert re.search(rf'Exporting graph in {tmp_path}/tree\.(svg|pdf) file\.\.\.$', output)


def test_view_frames_into_a_directory_that_is_not_there(domain, tmp_path):
    status, output = ended(domain.program('tf2_tools', 'view_frames', '-t', '0', '-o', tmp_path / 'no' / 'tree'))
    assert status == 1 and 'No such file or directory' in output and 'Traceback' not in output


def test_buffer_server_and_client(domain):
    domain.program('tf2_ros', 'buffer_server')
    node = domain.node('asking')
    client = tf2_ros.BufferClient(node, 'tf2_buffer_server')
    with pytest.raises(tf2_ros.TimeoutException):
        tf2_ros.BufferClient(node, 'no_such_server').lookup_transform('a', 'b', LATEST)
    domain.spin(node)
    assert client.action_client.wait_for_server(TIMEOUT)
    with pytest.raises(tf2_ros.LookupException, match='"a" passed to lookupTransform argument target_frame does not'):
        client.lookup_transform('a', 'b', LATEST)
    with pytest.raises(tf2_ros.InvalidArgumentException):
        client.lookup_transform('', 'b', LATEST, Duration(seconds=0.1))
    assert client.can_transform('a', 'b', LATEST) is False
    found = []
    waiter = threading.Thread(target=lambda: found.append(client.lookup_transform('a', 'b', LATEST, LONG)))
    waiter.start()
    domain.program('tf2_ros', 'static_transform_publisher', '--x', '7', '--frame-id', 'a', '--child-frame-id', 'b')
    waiter.join(TIMEOUT)
    assert [position(message) for message in found] == [(7, 0, 0)]
    assert client.can_transform_full('a', LATEST, 'b', Time(seconds=3), 'a') is True
    assert position(client.lookup_transform_full('b', LATEST, 'a', LATEST, 'a')) == (-7, 0, 0)
    with pytest.raises(TypeError, match='Must pass a rclpy.time.Time object.'):
        client.lookup_transform('a', 'b', 3.0)
