"""Command lines of Jazzy's official tutorials, each with the form of what it prints.

Beginner: CLI tools and client libraries (Python). Intermediate: tf2, actions, parameters, testing. The expectations are
this project's own words for what the tutorials show; where a number or a time stands there, any will do. Launch files
have tests of their own.
"""

import os
import re
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from environment.tests.ros2_command import ros2  # noqa: F401
from environment.tests.running import PATIENCE, program
from helpers.programs.processes import background

NUMBER = r'-?\d+\.\d+(?:e[-+]\d+)?'
ROBOT_SERVICES = (
    'describe_parameters|get_parameter_types|get_parameters|get_type_description|list_parameters|'
    'set_parameters|set_parameters_atomically'
)

# While `ros2 run turtlesim turtlesim_node` runs: tutorial, command line, and a pattern for the whole output.
LINES = [
    ('nodes', 'node list', r'/turtlesim\n'),
    (
        'nodes',
        'node info /turtlesim',
        r'/turtlesim\n  Subscribers:\n    /parameter_events: rcl_interfaces/msg/ParameterEvent\n'
        r'    /turtle1/cmd_vel: geometry_msgs/msg/Twist\n  Publishers:\n'
        r'    /parameter_events: rcl_interfaces/msg/ParameterEvent\n    /rosout: rcl_interfaces/msg/Log\n'
        r'    /turtle1/color_sensor: turtlesim/msg/Color\n    /turtle1/pose: turtlesim/msg/Pose\n'
        r'  Service Servers:\n(    /\S+: \S+\n){14}  Service Clients:\n\n  Action Servers:\n'
        r'    /turtle1/rotate_absolute: turtlesim/action/RotateAbsolute\n  Action Clients:\n\n',
    ),
    ('topics', 'topic list', r'/parameter_events\n/rosout\n/turtle1/cmd_vel\n/turtle1/color_sensor\n/turtle1/pose\n'),
    ('topics', 'topic list -t', r'(/\S+ \[\S+/msg/\S+\]\n){5}'),
    (
        'topics',
        'topic info /turtle1/cmd_vel',
        r'Type: geometry_msgs/msg/Twist\nPublisher count: 0\nSubscription count: 1\n',
    ),
    (
        'topics',
        'topic info /turtle1/pose -v',
        r'Type: turtlesim/msg/Pose\n\nPublisher count: 1\n\nNode name: turtlesim\n'
        r'Node namespace: /\nTopic type: turtlesim/msg/Pose\nTopic type hash: RIHS01_[0-9a-f]{64}\n'
        r'Endpoint type: PUBLISHER\nGID: ([0-9a-f]{2}\.){15}[0-9a-f]{2}\nQoS profile:\n(  .+\n)+\n'
        r'Subscription count: 0\n\n',
    ),
    (
        'topics',
        'interface show geometry_msgs/msg/Twist',
        r'(# .*\n)*\nVector3  linear\n(\tfloat64 [xyz]\n){3}Vector3  angular\n(\tfloat64 [xyz]\n){3}',
    ),
    (
        'topics',
        'topic echo --once /turtle1/pose',
        rf'x: {NUMBER}\ny: {NUMBER}\ntheta: {NUMBER}\nlinear_velocity: {NUMBER}\nangular_velocity: {NUMBER}\n---\n',
    ),
    (
        'topics',
        'topic pub --once -w 1 /turtle1/cmd_vel geometry_msgs/msg/Twist '
        '"{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 1.8}}"',
        r'(Waiting for at least 1 matching subscription\(s\)\.\.\.\n)*publisher: beginning loop\npublishing #1: '
        r'geometry_msgs\.msg\.Twist\(linear=geometry_msgs\.msg\.Vector3\(x=2\.0, y=0\.0, z=0\.0\), '
        r'angular=geometry_msgs\.msg\.Vector3\(x=0\.0, y=0\.0, z=1\.8\)\)\n\n',
    ),
    ('topics', 'topic find geometry_msgs/msg/Twist', r'/turtle1/cmd_vel\n'),
    (
        'services',
        'service list',
        r'/clear\n/kill\n/reset\n/spawn\n/turtle1/set_pen\n/turtle1/teleport_absolute\n'
        rf'/turtle1/teleport_relative\n(/turtlesim/({ROBOT_SERVICES})\n){{7}}',
    ),
    ('services', 'service type /clear', r'std_srvs/srv/Empty\n'),
    ('services', 'service list -t', r'(/\S+ \[\S+/srv/\S+\]\n){14}'),
    ('services', 'service info /clear', r'Type: std_srvs/srv/Empty\nClients count: 0\nServices count: 1\n'),
    ('services', 'service find std_srvs/srv/Empty', r'/clear\n/reset\n'),
    ('services', 'interface show std_srvs/srv/Empty', r'---\n'),
    (
        'services',
        'interface show turtlesim/srv/Spawn',
        r'float32 x\nfloat32 y\nfloat32 theta\nstring name( # .*)?\n---\nstring name\n',
    ),
    (
        'services',
        'service call /clear std_srvs/srv/Empty',
        r'(waiting for service to become available\.\.\.\n)?'
        r'requester: making request: std_srvs\.srv\.Empty_Request\(\)\n\n'
        r'response:\nstd_srvs\.srv\.Empty_Response\(\)\n\n',
    ),
    ('parameters', 'param list', r'/turtlesim:\n(  \S+\n)*  background_b\n  background_g\n  background_r\n(  \S+\n)*'),
    ('parameters', 'param get /turtlesim background_g', r'Integer value is: 86\n'),
    ('parameters', 'param set /turtlesim background_r 150', r'Set parameter successful\n'),
    (
        'parameters',
        'param dump /turtlesim',
        r'/turtlesim:\n  ros__parameters:\n    background_b: 255\n    background_g: 86\n    background_r: \d+\n'
        r'    holonomic: false\n    qos_overrides:\n      /parameter_events:\n        publisher:\n'
        r'          depth: 1000\n          durability: volatile\n          history: keep_last\n'
        r'          reliability: reliable\n    start_type_description_service: true\n    use_sim_time: false\n\n',
    ),
    ('actions', 'action list', r'/turtle1/rotate_absolute\n'),
    ('actions', 'action list -t', r'/turtle1/rotate_absolute \[turtlesim/action/RotateAbsolute\]\n'),
    ('actions', 'action type /turtle1/rotate_absolute', r'turtlesim/action/RotateAbsolute\n'),
    (
        'actions',
        'action info /turtle1/rotate_absolute',
        r'Action: /turtle1/rotate_absolute\nAction clients: 0\n'
        r'Action servers: 1\n    /turtlesim\n',
    ),
    (
        'actions',
        'interface show turtlesim/action/RotateAbsolute',
        r'(# .*\n)?float32 theta\n---\n(# .*\n)?float32 delta\n---\n(# .*\n)?float32 remaining\n',
    ),
    (
        'actions',
        'action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "{theta: 1.57}"',
        rf'Waiting for an action server to become available\.\.\.\nSending goal:\n     theta: 1\.57\n\n'
        rf'Goal accepted with ID: [0-9a-f]{{32}}\n\nResult:\n    delta: {NUMBER}\n\n'
        r'Goal finished with status: SUCCEEDED\n',
    ),
    (
        'actions',
        'action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "{theta: -1.57}" --feedback',
        r'Waiting for .*\nSending goal:\n     theta: -1\.57\n\n'
        rf'(Goal accepted with ID: [0-9a-f]{{32}}\n\n|Feedback:\n    '
        rf'remaining: {NUMBER}\n\n)+Result:\n    delta: {NUMBER}\n\nGoal finished with status: SUCCEEDED\n',
    ),
    (
        'running',
        'pkg executables turtlesim',
        r'turtlesim draw_square\nturtlesim mimic\nturtlesim turtle_teleop_key\n'
        r'turtlesim turtlesim_node\n',
    ),
    ('packages', 'pkg prefix turtlesim', r'/\S+\n'),
    ('interfaces', 'interface list -m', r'Messages:\n(    \S+/msg/\S+\n)+'),
    ('interfaces', 'interface proto geometry_msgs/msg/Point', r'"x: 0\.0\ny: 0\.0\nz: 0\.0\n"\n'),
    ('doctor', 'doctor', r'\nAll 5 checks passed\n\n'),
]


@pytest.fixture(scope='module')
def turtlesim(ros2):  # noqa: F811
    """The simulator of the tutorials."""
    with background([program('turtlesim', 'turtlesim_node')], env=ros2.environ) as process:
        process.wait_for_output('Spawning turtle [turtle1]', PATIENCE)
        yield process


@pytest.mark.usefixtures('turtlesim')
@pytest.mark.one_of(5)
@pytest.mark.parametrize('tutorial,line,pattern', LINES, ids=[line for _, line, _ in LINES])
def test_command_line(ros2, tutorial, line, pattern):  # noqa: F811
    done = run_line(ros2, line)
    assert done.returncode == 0, done
    assert re.fullmatch(pattern, done.stdout), done.stdout


@pytest.mark.one_of(2)
@pytest.mark.usefixtures('turtlesim')
def test_a_second_turtle_comes_and_goes(ros2):  # noqa: F811
    """One test, as the other lines expect the first turtle only."""
    spawned = run_line(ros2, 'service call /spawn turtlesim/srv/Spawn "{x: 2, y: 2, theta: 0.2, name: \'\'}"')
    killed = run_line(ros2, 'service call /kill turtlesim/srv/Kill "{name: \'turtle2\'}"')
    assert re.fullmatch(
        r'(waiting .*\n)?requester: making request: '
        r"turtlesim\.srv\.Spawn_Request\(x=2\.0, y=2\.0, theta=0\.2, name=''\)"
        r"\n\nresponse:\nturtlesim\.srv\.Spawn_Response\(name='turtle2'\)\n\n",
        spawned.stdout,
    )
    assert re.fullmatch(
        r'(waiting .*\n)?requester: [^\n]+\n\nresponse:\nturtlesim\.srv\.Kill_Response\(\)\n\n', killed.stdout
    )


def run_line(ros2, line):  # noqa: F811
    """Run what stands behind `ros2`, with the shell's quotes, to its end."""
    return subprocess.run(
        f'ros2 {line}',
        shell=True,
        env=with_programs(ros2),
        cwd=ros2.directory,
        capture_output=True,
        text=True,
        timeout=2 * PATIENCE,
    )


def with_programs(ros2):  # noqa: F811
    """The environment of a terminal in which the course is active."""
    first = str(Path(sys.executable).parent)
    return {
        **ros2.environ,
        'PATH': f'{first}:{os.environ["PATH"]}',
        'ROS_DISTRO': 'jazzy',
        'ROS_VERSION': '2',
        'ROS_PYTHON_VERSION': '3',
    }


# Those that go on until Ctrl+C: the command line, and a line that it prints.
STREAMS = [
    ('topic hz /turtle1/pose', r'average rate: \d+\.\d{3}'),
    ('topic bw /turtle1/pose', r'\d+(\.\d+)? [KM]?B/s from \d+ messages'),
    ('topic pub --rate 5 /turtle1/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 2.0}}"', r'publishing #3: geometry_'),
]


@pytest.mark.usefixtures('turtlesim')
@pytest.mark.one_of(2)
@pytest.mark.parametrize('line,pattern', STREAMS, ids=[line for line, _ in STREAMS])
def test_command_line_that_goes_on(ros2, line, pattern):  # noqa: F811
    with background(['sh', '-c', f'exec ros2 {line}'], env=with_programs(ros2)) as process:
        process.wait_for_output(lambda text: re.match(pattern, text.strip()), PATIENCE)


@pytest.mark.one_of(2)
def test_parameters_are_saved_and_loaded(ros2, turtlesim):  # noqa: F811
    saved = ros2.output('param', 'dump', '/turtlesim')
    (ros2.directory / 'turtlesim.yaml').write_text(saved.replace('background_b: 255', 'background_b: 30'))
    loaded = ros2.run('param', 'load', '/turtlesim', 'turtlesim.yaml')
    changed = ['background_b', 'background_g', 'background_r', 'holonomic', 'use_sim_time']
    assert loaded.stdout.splitlines() == [f'Set parameter {name} successful' for name in changed]
    fixed = [f'qos_overrides./parameter_events.publisher.{each}' for each in ('depth', 'durability', 'history')]
    fixed += ['qos_overrides./parameter_events.publisher.reliability', 'start_type_description_service']
    assert loaded.stderr.splitlines() == [
        f"Set parameter {name} failed: parameter '{name}' cannot be set because it is read-only" for name in fixed
    ]
    assert ros2.output('param', 'get', '/turtlesim', 'background_b') == 'Integer value is: 30\n'


@pytest.mark.one_of(2)
def test_a_second_turtlesim_is_remapped(ros2, turtlesim):  # noqa: F811
    with ros2.start('run', 'turtlesim', 'turtlesim_node', '--ros-args', '--remap', '__node:=my_turtle') as other:
        other.wait_for_output('Spawning turtle [turtle1]', PATIENCE)
        assert ros2.lines('node', 'list') == ['/my_turtle', '/turtlesim']


@pytest.mark.one_of(2)
def test_frames_of_tf2(ros2):  # noqa: F811
    """Introducing tf2, static broadcaster, debugging: a transform is published, echoed and drawn."""
    frames = [
        '--x',
        '0',
        '--y',
        '0',
        '--z',
        '1',
        '--yaw',
        '0',
        '--pitch',
        '0',
        '--roll',
        '0',
        '--frame-id',
        'world',
        '--child-frame-id',
        'mystaticturtle',
    ]
    with ros2.start('run', 'tf2_ros', 'static_transform_publisher', *frames) as publisher:
        publisher.wait_for_output('Spinning until stopped - publishing transform', PATIENCE)
        assert re.search(
            r'frame_id: world\n  child_frame_id: mystaticturtle\n  transform:\n    translation:\n      '
            r'x: 0\.0\n      y: 0\.0\n      z: 1\.0\n',
            ros2.output(
                'topic',
                'echo',
                '--once',
                '--qos-durability',
                'transient_local',
                '--qos-reliability',
                'reliable',
                '/tf_static',
                'tf2_msgs/msg/TFMessage',
            ),
        )
        with ros2.start('run', 'tf2_ros', 'tf2_echo', 'world', 'mystaticturtle') as echo:
            echo.wait_for_output('At time 0.0', PATIENCE)
            echo.wait_for_output('- Translation: [0.000, 0.000, 1.000]', PATIENCE)
            echo.wait_for_output('- Rotation: in Quaternion', PATIENCE)
            echo.wait_for_output('- Matrix:', PATIENCE)
        drawn = ros2.run('run', 'tf2_tools', 'view_frames')
        assert drawn.returncode == 0
        assert list(ros2.directory.glob('frames*.gv')) or list(ros2.directory.glob('frames*.pdf'))


TALKER = """
    import rclpy
    from rclpy.executors import ExternalShutdownException
    from rclpy.node import Node
    from std_msgs.msg import String


    class MinimalPublisher(Node):

        def __init__(self):
            super().__init__('minimal_publisher')
            self.declare_parameter('my_parameter', 'world')
            self.publisher_ = self.create_publisher(String, 'topic', 10)
            self.timer = self.create_timer(0.1, self.timer_callback)

        def timer_callback(self):
            msg = String()
            msg.data = 'Hello ' + self.get_parameter('my_parameter').value
            self.publisher_.publish(msg)
            self.get_logger().info('Publishing: "%s"' % msg.data)


    def main(args=None):
        try:
            rclpy.init(args=args)
            rclpy.spin(MinimalPublisher())
        except (KeyboardInterrupt, ExternalShutdownException):
            pass
"""


@pytest.mark.one_of(10, group=9, of='builds')
@pytest.mark.early
def test_a_package_of_the_learners_own(ros2, tmp_path):  # noqa: F811
    """Creating a package, publisher and subscriber, parameters in a class, testing: from nothing to a passing test."""
    environ, source = with_programs(ros2), tmp_path / 'src'
    source.mkdir()

    def run(command):
        done = subprocess.run(
            ['bash', '-c', command], env=environ, cwd=tmp_path, capture_output=True, text=True, timeout=4 * PATIENCE
        )
        assert done.returncode == 0, done
        return done.stdout

    run(
        'cd src && ros2 pkg create --build-type ament_python --license Apache-2.0 py_pubsub --node-name talker '
        '--dependencies rclpy std_msgs'
    )
    (source / 'py_pubsub/py_pubsub/talker.py').write_text(textwrap.dedent(TALKER).lstrip())
    (source / 'py_pubsub/test/test_sum.py').write_text('def test_sum():\n    assert 1 + 1 == 2\n')
    assert 'Summary: 1 package finished' in run('colcon build --packages-select py_pubsub')
    start = [
        'bash',
        '-c',
        'source install/setup.bash && exec ros2 run py_pubsub talker --ros-args -p my_parameter:=earth',
    ]
    with background(start, env=environ, cwd=tmp_path) as talker:
        talker.wait_for_output('[minimal_publisher]: Publishing: "Hello earth"', PATIENCE)
        assert ros2.output('topic', 'echo', '--once', '/topic') == 'data: Hello earth\n---\n'
        assert ros2.output('param', 'set', '/minimal_publisher', 'my_parameter', 'moon') == 'Set parameter successful\n'
        talker.wait_for_output('Publishing: "Hello moon"', PATIENCE)
    run('colcon test --packages-select py_pubsub --return-code-on-test-failure')
    assert 'Summary: 4 tests, 0 errors, 0 failures, 1 skipped' in run('colcon test-result --all')
