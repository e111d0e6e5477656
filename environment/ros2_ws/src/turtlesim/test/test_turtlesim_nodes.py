"""The nodes as real processes: what they print, publish and answer is what stock turtlesim does."""

import json
import math
import signal
import termios
import time
from pathlib import Path

import pytest
from action_msgs.msg import GoalStatus
from ament_index_python.packages import get_package_share_directory
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import DescribeParameters, SetParameters
from rclpy.action import ActionClient
from std_srvs.srv import Empty
from turtlesim.action import RotateAbsolute
from turtlesim.msg import Color, Pose
from turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative

from environment.tests.running import program
from helpers import paths

HASHES = paths.ROOT / 'environment' / 'tests' / 'type_hashes.json'
STARTED = 'Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]'
INTERFACES = ['msg/Color', 'msg/Pose', 'srv/Kill', 'srv/SetPen', 'srv/Spawn', 'srv/TeleportAbsolute',
              'srv/TeleportRelative', 'action/RotateAbsolute']  # fmt: skip


@pytest.fixture
def simulator(start):
    """A running turtlesim_node without a display."""
    process = start(program('turtlesim', 'turtlesim_node'), env={'DISPLAY': '', 'WAYLAND_DISPLAY': ''})
    process.wait_for_output(STARTED, timeout=30)
    return process


def drive(linear=0.0, angular=0.0):
    twist = Twist()
    twist.linear.x, twist.angular.z = linear, angular
    return twist


def rotate(peer, theta):
    """Send a rotation goal; return its handle and the feedback list."""
    client = ActionClient(peer.node, RotateAbsolute, '/turtle1/rotate_absolute')
    peer.until(client.server_is_ready, 'the action server')
    feedback = []
    goal = RotateAbsolute.Goal(theta=theta)
    handle = peer.result(client.send_goal_async(goal, feedback_callback=feedback.append), 'the goal response')
    assert handle.accepted
    return handle, feedback


@pytest.mark.parametrize('name', INTERFACES)
def test_interfaces_are_upstreams(name):
    description = json.loads(Path(get_package_share_directory('turtlesim'), f'{name}.json').read_text())
    hashes = {entry['type_name']: entry['hash_string'] for entry in description['type_hashes']}
    assert hashes[f'turtlesim/{name}'] == json.loads(HASHES.read_text())[f'turtlesim/{name}']


def wait_for_pose(peer, name='turtle1'):
    """Wait until the simulator is at work: right after a line of its log a signal could still meet that line."""
    poses = peer.listen(Pose, f'/{name}/pose')
    peer.until(lambda: poses, 'a pose')


def test_it_starts_with_stocks_lines_and_ends_well(simulator, peer):
    wait_for_pose(peer)
    assert simulator.lines == [
        '[INFO] [turtlesim]: Running without a window: there is no display',
        '[INFO] [turtlesim]: Starting turtlesim with node name /turtlesim',
        f'[INFO] [turtlesim]: {STARTED}',
    ]
    assert simulator.stop(timeout=30) == 0
    assert len(simulator.lines) == 3, simulator.output


@pytest.mark.parametrize('name', ['turtlesim_node', 'mimic'])
def test_ros_arguments_that_cannot_be_read_are_told(start, tmp_path, name):
    (tmp_path / 'bad.yaml').write_text('a: [')
    process = start(program('turtlesim', name), '--ros-args', '--params-file', str(tmp_path / 'bad.yaml'))
    process.wait_for_output("Couldn't parse params file", timeout=30)
    assert process._popen.wait(30) == 1
    assert 'Traceback' not in process.output


def test_unknown_ros_arguments_are_told(start):
    process = start(program('turtlesim', 'turtlesim_node'), '--ros-args', '--help')
    process.wait_for_output("turtlesim_node: found unknown ROS arguments: ['--help']", timeout=30)
    assert process._popen.wait(30) == 1
    assert 'Traceback' not in process.output


def test_a_parameter_of_a_wrong_type_is_told(start):
    process = start(program('turtlesim', 'turtlesim_node'), '--ros-args', '-p', 'background_r:=red')
    process.wait_for_output("turtlesim_node: Trying to set parameter 'background_r' to 'red'", timeout=30)
    assert process._popen.wait(30) == 1
    assert 'Traceback' not in process.output


@pytest.mark.parametrize('override', ['reliability:=nonsense', 'depth:=-4'])
def test_a_quality_of_service_that_does_not_exist_is_told(start, override):
    name = 'qos_overrides./parameter_events.publisher'
    process = start(program('turtlesim', 'turtlesim_node'), '--ros-args', '-p', f'{name}.{override}')
    assert process._popen.wait(30) == 1
    process.wait_for_output(override.replace(':=', ': '), timeout=30)
    process.wait_for_output(name, timeout=30)
    assert 'Traceback' not in process.output


def test_it_is_on_the_graph_as_stock_is(simulator, peer):
    node = peer.node
    services = {
        '/clear': 'std_srvs/srv/Empty', '/reset': 'std_srvs/srv/Empty',
        '/kill': 'turtlesim/srv/Kill', '/spawn': 'turtlesim/srv/Spawn', '/turtle1/set_pen': 'turtlesim/srv/SetPen',
        '/turtle1/teleport_absolute': 'turtlesim/srv/TeleportAbsolute',
        '/turtle1/teleport_relative': 'turtlesim/srv/TeleportRelative',
    }  # fmt: skip

    def complete():
        if 'turtlesim' not in node.get_node_names():
            return False
        served = dict(node.get_service_names_and_types_by_node('turtlesim', '/'))
        published = dict(node.get_publisher_names_and_types_by_node('turtlesim', '/'))
        read = dict(node.get_subscriber_names_and_types_by_node('turtlesim', '/'))
        return (
            all(served.get(name) == [kind] for name, kind in services.items())
            and published.get('/turtle1/pose') == ['turtlesim/msg/Pose']
            and published.get('/turtle1/color_sensor') == ['turtlesim/msg/Color']
            and read.get('/turtle1/cmd_vel') == ['geometry_msgs/msg/Twist']
        )

    peer.until(complete, 'the services and topics of stock turtlesim')


def test_the_pose_comes_every_16_ms_and_each_is_a_step_of_16_ms(simulator, peer):
    begin = time.monotonic()  # before the first: what came while this process had to wait is read at once
    poses = peer.listen(Pose, '/turtle1/pose')
    peer.until(lambda: len(poses) > 125, '125 poses')
    assert time.monotonic() - begin > 1.8, 'the poses come faster than 62.5 Hz'
    commands = peer.publisher(Twist, '/turtle1/cmd_vel')
    commands.publish(drive(linear=1.0))
    peer.until(lambda: poses[-1].linear_velocity == 1.0, 'motion')
    peer.until(lambda: poses[-1].linear_velocity == 0.0, 'the end of motion one second later')
    moving = [pose.x for pose in poses if pose.linear_velocity == 1.0]
    steps = [(b - a) / 0.016 for a, b in zip(moving, moving[1:], strict=False)]
    assert steps and all(step == pytest.approx(round(step), abs=1e-3) for step in steps)
    travelled = poses[-1].x - 5.544445
    assert 0.0 < travelled < 1.05, 'a command drives for a second of 1 m/s'


def test_walls_are_reported_in_stocks_words(simulator, peer):
    peer.call(TeleportAbsolute, '/turtle1/teleport_absolute', x=20.0, y=5.0, theta=0.0)
    line = simulator.wait_for_output('Oh no!', timeout=30)
    # 5.0 from below is 6.088889 from above
    assert line == '[WARN] [turtlesim]: Oh no! I hit the wall! (Clamping from [x=20.000000, y=6.088889])'
    poses = peer.listen(Pose, '/turtle1/pose')
    peer.until(lambda: poses, 'a pose')
    assert f'{poses[-1].x:.6f}' == '11.088889'


def test_the_services_of_a_turtle(simulator, peer):
    colors = peer.listen(Color, '/turtle1/color_sensor')
    poses = peer.listen(Pose, '/turtle1/pose')
    peer.call(SetPen, '/turtle1/set_pen', r=10, g=20, b=30, width=9, off=0)
    peer.call(TeleportRelative, '/turtle1/teleport_relative', linear=1.0, angular=math.pi / 2)
    peer.until(lambda: poses and abs(poses[-1].y - 6.544445) < 1e-5, 'the turtle one metre up')
    assert poses[-1].theta == pytest.approx(math.pi / 2, abs=1e-5)
    peer.until(lambda: colors and (colors[-1].r, colors[-1].g, colors[-1].b) == (10, 20, 30), 'the pen below')
    peer.call(Empty, '/clear')
    peer.until(lambda: (colors[-1].r, colors[-1].g, colors[-1].b) == (255, 255, 255), 'clean paper below')
    simulator.wait_for_output('Clearing turtlesim.', timeout=30)


def test_spawn_kill_and_reset(simulator, peer):
    assert peer.call(Spawn, '/spawn', x=1.0, y=2.0, theta=0.5, name='').name == 'turtle2'
    simulator.wait_for_output('Spawning turtle [turtle2] at x=[1.000000], y=[2.000000], theta=[0.500000]', timeout=30)
    assert peer.call(Spawn, '/spawn', name='turtle2').name == ''
    simulator.wait_for_output('[ERROR] [turtlesim]: A turtle named [turtle2] already exists', timeout=30)
    assert peer.call(Spawn, '/spawn', name='no good').name == ''
    simulator.wait_for_output('[ERROR] [turtlesim]: Cannot spawn turtle [no good]: Invalid topic name', timeout=30)
    assert peer.call(Spawn, '/spawn', x=math.nan).name == ''
    simulator.wait_for_output('[ERROR] [turtlesim]: Cannot spawn turtle []: x is nan, not a finite number', timeout=30)
    peer.listen(Pose, '/turtle2/pose')
    peer.call(Kill, '/kill', name='turtle2')
    peer.until(lambda: not peer.node.count_publishers('/turtle2/pose'), 'the end of /turtle2/pose')
    peer.call(Kill, '/kill', name='turtle2')
    simulator.wait_for_output('[ERROR] [turtlesim]: Tried to kill turtle [turtle2], which does not exist', timeout=30)
    peer.call(TeleportAbsolute, '/turtle1/teleport_absolute', x=1.0, y=1.0, theta=1.0)
    peer.call(Empty, '/reset')
    simulator.wait_for_output('Resetting turtlesim.', timeout=30)
    simulator.wait_for_output(lambda line: STARTED in line and simulator.lines.count(line) == 2, timeout=30)
    poses = peer.listen(Pose, '/turtle1/pose')
    peer.until(lambda: poses and abs(poses[-1].x - 5.544445) < 1e-5, 'the turtle in the middle')


def test_turtles_come_and_go_under_load(simulator, peer):
    for _ in range(8):
        name = peer.call(Spawn, '/spawn', x=3.0, y=3.0).name
        commands = peer.publisher(Twist, f'/{name}/cmd_vel')
        for _ in range(20):
            commands.publish(drive(linear=1.0))
        peer.call(Kill, '/kill', name=name)
    assert peer.call(Spawn, '/spawn', name='last').name == 'last'
    assert simulator.running


def test_a_rotation_succeeds_with_feedback_and_result(simulator, peer):
    handle, feedback = rotate(peer, 3.0)
    result = handle.get_result_async()
    peer.until(lambda: len(feedback) > 1, 'feedback')
    answer = peer.result(result, 'the result')
    assert answer.status == GoalStatus.STATUS_SUCCEEDED
    assert answer.result.delta == pytest.approx(-3.0, abs=0.025)
    remaining = [message.feedback.remaining for message in feedback]
    assert remaining == sorted(remaining, reverse=True) and 0.0 < remaining[-1] < remaining[0] <= 3.0
    simulator.wait_for_output('[INFO] [turtlesim]: Rotation goal completed successfully', timeout=30)


def test_a_rotation_is_executing_at_once_and_can_be_cancelled(simulator, peer):
    handle, feedback = rotate(peer, 3.0)
    peer.until(lambda: feedback, 'feedback')
    assert handle.status in (GoalStatus.STATUS_EXECUTING, GoalStatus.STATUS_ACCEPTED)
    peer.until(lambda: handle.status == GoalStatus.STATUS_EXECUTING, 'the status EXECUTING')
    peer.result(handle.cancel_goal_async(), 'the cancel response')
    assert peer.result(handle.get_result_async(), 'the result').status == GoalStatus.STATUS_CANCELED
    simulator.wait_for_output('[INFO] [turtlesim]: Rotation goal canceled', timeout=30)


def test_a_new_rotation_aborts_the_old_one(simulator, peer):
    first, _ = rotate(peer, 3.0)
    second, _ = rotate(peer, 0.1)
    assert peer.result(first.get_result_async(), 'the first result').status == GoalStatus.STATUS_ABORTED
    assert peer.result(second.get_result_async(), 'the second result').status == GoalStatus.STATUS_SUCCEEDED
    simulator.wait_for_output(
        '[WARN] [turtlesim]: Rotation goal received before a previous goal finished. Aborting previous goal', timeout=30
    )


@pytest.mark.parametrize('how', ['command', 'kill', 'reset'])
def test_a_rotation_is_aborted_when_something_else_happens(simulator, peer, how):
    handle, _ = rotate(peer, 3.0)
    if how == 'command':
        result = handle.get_result_async()
        peer.publisher(Twist, '/turtle1/cmd_vel').publish(drive(linear=0.1))
        assert peer.result(result, 'the result').status == GoalStatus.STATUS_ABORTED
        simulator.wait_for_output(
            '[WARN] [turtlesim]: Velocity command received during rotation goal. Aborting goal', timeout=30
        )
    else:
        # The action goes away with the turtle, so only that the simulator lives on is to be seen.
        if how == 'kill':
            peer.call(Kill, '/kill', name='turtle1')
        else:
            peer.call(Empty, '/reset')
        assert peer.call(Spawn, '/spawn', name='next').name == 'next'


def test_bad_numbers_are_refused_with_one_line(simulator, peer):
    peer.publisher(Twist, '/turtle1/cmd_vel').publish(drive(linear=math.nan))
    simulator.wait_for_output(
        '[ERROR] [turtlesim]: Ignoring velocity command: linear is nan, not a finite number', timeout=30
    )
    peer.call(TeleportAbsolute, '/turtle1/teleport_absolute', x=math.inf)
    simulator.wait_for_output('[ERROR] [turtlesim]: Ignoring teleport_absolute request: x is inf', timeout=30)
    handle, _ = rotate(peer, math.nan)
    assert peer.result(handle.get_result_async(), 'the result').status == GoalStatus.STATUS_ABORTED
    simulator.wait_for_output('[ERROR] [turtlesim]: Ignoring rotate_absolute goal: theta is nan', timeout=30)
    poses = peer.listen(Pose, '/turtle1/pose')
    peer.until(lambda: poses, 'a pose')
    assert poses[-1].x == pytest.approx(5.544445, abs=1e-5)


def test_the_background_parameters_have_stocks_defaults_and_limits(simulator, peer):
    answer = peer.call(DescribeParameters, '/turtlesim/describe_parameters', names=['background_r', 'holonomic'])
    background, holonomic = answer.descriptors
    assert background.description == 'Red channel of the background color'
    limits = background.integer_range[0]
    assert (limits.from_value, limits.to_value, limits.step) == (0, 255, 1)
    assert holonomic.description == 'If true, then turtles will be holonomic'

    def set_red(value):
        red = ParameterValue(type=ParameterType.PARAMETER_INTEGER, integer_value=value)
        parameters = [Parameter(name='background_r', value=red)]
        return peer.call(SetParameters, '/turtlesim/set_parameters', parameters=parameters).results[0].successful

    assert set_red(150) and not set_red(300)


def test_draw_square_and_mimic_drive(simulator, peer, start):
    assert peer.call(Spawn, '/spawn', x=2.0, y=2.0, name='follower').name == 'follower'
    mimic = start(
        program('turtlesim', 'mimic'), '--ros-args', '-r', 'input/pose:=turtle1/pose',
        '-r', 'output/cmd_vel:=follower/cmd_vel',
    )  # fmt: skip
    followed = peer.listen(Twist, '/follower/cmd_vel')
    square = start(program('turtlesim', 'draw_square'))
    goal = square.wait_for_output('New goal', timeout=30)
    assert goal == '[INFO] [draw_square]: New goal [7.544445 5.544445, 0.000000]'
    simulator.wait_for_output('Resetting turtlesim.', timeout=30)
    peer.until(lambda: any(twist.linear.x == 1.0 for twist in followed), 'the follower at 1 m/s')
    square.wait_for_output('[INFO] [draw_square]: Reached goal', timeout=60)
    assert (square.stop(timeout=30), mimic.stop(timeout=30)) == (0, 0)
    assert not [line for line in square.lines + mimic.lines if 'Traceback' in line]


def test_sigterm_ends_it_quietly(simulator, peer):
    wait_for_pose(peer)
    simulator._signal(signal.SIGTERM)
    simulator._popen.wait(30)
    assert simulator.stop() == 0
    assert len(simulator.lines) == 3, simulator.output


HELP = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle.
Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.
'Q' to quit.
"""


def settings(terminal):
    return termios.tcgetattr(terminal.slave)


def test_teleop_drives_with_arrow_keys_on_a_terminal(terminal, peer):
    keys = terminal(program('turtlesim', 'turtle_teleop_key'))
    before = settings(keys)
    keys.read_until(HELP)
    assert keys.text == HELP
    assert not settings(keys)[3] & (termios.ICANON | termios.ECHO)
    twists = peer.listen(Twist, '/turtle1/cmd_vel')

    # The first key may come before the two know each other: it is pressed until one arrives.
    def arrived():
        keys.press('\x1b[A')
        return twists

    peer.until(arrived, 'the first command')
    expected = {'\x1b[B': (-2.0, 0.0), '\x1b[D': (0.0, 2.0), '\x1b[C': (0.0, -2.0)}
    for key, (linear, angular) in expected.items():
        keys.press(key)
        peer.until(lambda: (twists[-1].linear.x, twists[-1].angular.z) == (linear, angular), f'{key!r}')  # noqa: B023
    keys.press('q')
    assert keys.wait() == 0
    assert keys.text == HELP, 'keys are not echoed'
    assert settings(keys) == before


def test_teleop_rotates_and_cancels(terminal, simulator, peer):
    keys = terminal(program('turtlesim', 'turtle_teleop_key'))
    keys.read_until(HELP)
    poses = peer.listen(Pose, '/turtle1/pose')
    status = peer.listen_status('/turtle1/rotate_absolute')

    def rotating():
        keys.press('d')  # until the action server has been found
        return poses and poses[-1].angular_velocity

    peer.until(rotating, 'a rotation')
    peer.until(lambda: GoalStatus.STATUS_EXECUTING in status(), 'the goal')

    def cancelled():
        keys.press('f')
        return any('Rotation goal canceled' in line for line in simulator.lines)

    peer.until(cancelled, 'the end of the rotation')
    keys.press('T')
    simulator.wait_for_output('Rotation goal completed successfully', timeout=30)
    peer.until(lambda: abs(poses[-1].theta - 0.7854) < 0.03, 'the heading of T')
    keys.press('\x03')
    assert keys.wait() == 0
    assert 'Traceback' not in keys.text


@pytest.mark.parametrize('end', ['ctrl-c', 'sigterm', 'eof'])
def test_teleop_puts_the_terminal_back(terminal, start, end):
    if end == 'eof':  # background gives its programs no input
        keys = start(program('turtlesim', 'turtle_teleop_key'))
        keys._popen.wait(30)
        assert keys.returncode == 0
        return
    keys = terminal(program('turtlesim', 'turtle_teleop_key'))
    before = settings(keys)
    keys.read_until(HELP)
    if end == 'ctrl-c':
        keys.press('\x03')
    else:
        keys._process.send_signal(signal.SIGTERM)
    assert keys.wait() == 0
    assert settings(keys) == before
    assert 'Traceback' not in keys.text
