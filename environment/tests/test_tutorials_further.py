"""Further command lines of Jazzy's official tutorials: options, lists of types, refusals, files, a recorded turtle.

As in test_tutorials.py the expectations are this project's own words for what the tutorials show. Each line is followed
by its exit status and a pattern for the whole of what it prints; what a refused line says comes on stderr.
"""

import re
import sys

import pytest

from environment.tests.ros2_command import ros2  # noqa: F401
from environment.tests.running import PATIENCE
from environment.tests.test_tutorials import NUMBER, run_line, turtlesim, with_programs  # noqa: F401
from helpers.programs.processes import background

OVERRIDES = [f'qos_overrides./parameter_events.publisher.{each}'
             for each in ('depth', 'durability', 'history', 'reliability')]  # fmt: skip
PARAMETERS = ['background_b', 'background_g', 'background_r', 'holonomic', *OVERRIDES, 'start_type_description_service']
TYPES = ['integer', 'integer', 'integer', 'boolean', 'integer', 'string', 'string', 'string', 'boolean']
WAITING = r'(waiting for service to become available\.\.\.\n)?'

# While `ros2 run turtlesim turtlesim_node` runs.
LINES = [
    # Understanding nodes
    ('node list -c', r'1\n'),
    ('node list --all', r'/_ros2cli_\d+\n/turtlesim\n'),
    # Understanding topics
    ('topic list -c', r'5\n'),
    ('topic list --show-types', r'(/\S+ \[\S+/msg/\S+\]\n){5}'),
    ('topic list -v', r'Published topics:\n( \* /\S+ \[\S+\] \d publishers?\n){4}\nSubscribed topics:\n'
     r'( \* /\S+ \[\S+\] \d subscribers?\n){1,2}\n+'),
    ('topic type /turtle1/pose', r'turtlesim/msg/Pose\n'),
    ('topic find turtlesim/msg/Pose', r'/turtle1/pose\n'),
    ('topic info /turtle1/cmd_vel --verbose', r'(?s)Type: geometry_msgs/msg/Twist\n\nPublisher count: 0\n\n'
     r'Subscription count: 1\n\nNode name: turtlesim\n.*Endpoint type: SUBSCRIPTION\n.*'),
    ('topic echo --once --field x /turtle1/pose', rf'{NUMBER}\n---\n'),
    ('topic echo --once --csv /turtle1/pose', rf'({NUMBER},){{4}}{NUMBER}\n'),
    ('topic echo --once --flow-style /turtle1/color_sensor', r'r: \d+\ng: \d+\nb: \d+\n---\n'),
    ('topic echo --once --qos-profile sensor_data --qos-reliability best_effort /turtle1/pose',
     rf'(\w+: {NUMBER}\n){{5}}---\n'),
    ('topic pub --times 2 --rate 10 -w 0 /turtle1/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 2.0}}"',
     r'publisher: beginning loop\n(publishing #[12]: geometry_msgs\.msg\.Twist\(linear=[^\n]+\)\n\n){2}'),
    ('topic pub --once -w 0 /pose geometry_msgs/msg/PoseStamped \'{header: "auto", pose: {position: {x: 1.0}}}\'',
     r'publisher: beginning loop\npublishing #1: geometry_msgs\.msg\.PoseStamped\(header=std_msgs\.msg\.Header\('
     r'stamp=builtin_interfaces\.msg\.Time\(sec=[1-9]\d+, nanosec=\d+\), .*x=1\.0, .*\)\n\n'),
    ('topic pub --once -w 0 /reference sensor_msgs/msg/TimeReference \'{header: "auto", time_ref: "now"}\'',
     r'publisher: beginning loop\npublishing #1: sensor_msgs\.msg\.TimeReference\(.*time_ref=builtin_interfaces\.msg\.'
     r'Time\(sec=[1-9]\d+, .*\)\n\n'),
    (r"topic pub --once -w 0 /copied geometry_msgs/msg/Vector3 \'x:\ 1.0\^Jy:\ 0.0\^Jz:\ 0.0\^J\'",
     r'publisher: beginning loop\npublishing #1: geometry_msgs\.msg\.Vector3\(x=1\.0, y=0\.0, z=0\.0\)\n\n'),
    # Understanding services
    ('service list -c', r'14\n'),
    ('service find turtlesim/srv/Spawn', r'/spawn\n'),
    ('service call /turtle1/set_pen turtlesim/srv/SetPen "{r: 255, g: 0, b: 0, width: 5, \'off\': 0}"',
     WAITING + r'requester: making request: turtlesim\.srv\.SetPen_Request\(r=255, g=0, b=0, width=5, off=0\)\n\n'
     r'response:\nturtlesim\.srv\.SetPen_Response\(\)\n\n'),
    ('service call /turtle1/teleport_absolute turtlesim/srv/TeleportAbsolute "{x: 1, y: 1, theta: 0}"',
     WAITING + r'requester: making request: turtlesim\.srv\.TeleportAbsolute_Request\(x=1\.0, y=1\.0, theta=0\.0\)\n\n'
     r'response:\nturtlesim\.srv\.TeleportAbsolute_Response\(\)\n\n'),
    ('service call /reset std_srvs/srv/Empty', WAITING + r'requester: making request: std_srvs\.srv\.Empty_Request\(\)'
     r'\n\nresponse:\nstd_srvs\.srv\.Empty_Response\(\)\n\n'),
    ('interface show turtlesim/srv/Kill', r'string name\n---\n'),
    # Understanding parameters
    ('param list /turtlesim', ''.join(rf'  {each}\n' for each in [*PARAMETERS, 'use_sim_time'])),
    ('param list --param-type', r'/turtlesim:\n'
     + ''.join(rf'  {each} \(type: {kind}\)\n' for each, kind in zip(PARAMETERS, TYPES, strict=True))
     + r'  use_sim_time \(type: boolean\)\n'),
    ('param list --filter "background.*"', r'/turtlesim:\n  background_b\n  background_g\n  background_r\n'),
    ('param get --hide-type /turtlesim background_g', r'86\n'),
    ('param describe /turtlesim background_r', r'Parameter name: background_r\n  Type: integer\n  Description: .+\n'
     r'  Constraints:\n    Min value: 0\n    Max value: 255\n    Step: 1\n'),
    # Understanding actions
    ('action list -c', r'1\n'),
    ('action info /turtle1/rotate_absolute -c', r'Action: /turtle1/rotate_absolute\nAction clients: 0\n'
     r'Action servers: 1\n'),
    ('action info /turtle1/rotate_absolute -t', r'Action: /turtle1/rotate_absolute\nAction clients: 0\n'
     r'Action servers: 1\n    /turtlesim \[turtlesim/action/RotateAbsolute\]\n'),
    # Custom interfaces, single package; about interfaces
    ('interface package turtlesim', r'turtlesim/action/RotateAbsolute\n(turtlesim/msg/\w+\n){2}'
     r'(turtlesim/srv/\w+\n){5}'),
    ('interface packages -a', r'(\w+\n)*turtlesim\n(\w+\n)*'),
    ('interface show turtlesim/msg/Color', r'uint8 r\nuint8 g\nuint8 b\n'),
    ('interface proto --no-quotes turtlesim/srv/Spawn', r"x: 0\.0\ny: 0\.0\ntheta: 0\.0\nname: ''\n\n"),
    # Creating a package; finding things
    ('pkg prefix --share turtlesim', r'/\S+/share/turtlesim\n'),
    ('pkg xml turtlesim --tag name', r'turtlesim\n'),
    ('pkg executables --full-path turtlesim', r'(/\S+/lib/turtlesim/\w+\n){4}'),
    ('run --prefix "echo started by" turtlesim mimic', r'started by /\S+/lib/turtlesim/mimic\n'),
    # Demos: lifecycle; the daemon
    ('lifecycle nodes', ''),
    ('daemon status', r'The daemon is not running\n'),
    ('daemon stop', r'The daemon is not running\n'),
]  # fmt: skip

# What is refused: the line, its status, and the last line that it says.
REFUSED = [
    ('param set /turtlesim background_r red', 0,
     'Setting parameter failed: Wrong parameter type, parameter {background_r} is of type {integer}, '
     'setting it to {string} is not allowed.'),
    ('param set /turtlesim background_r 256', 0,
     "Setting parameter failed: Parameter {background_r} doesn't comply with integer range."),
    ('param set /turtlesim nothing 1', 0,
     "Setting parameter failed: parameter 'nothing' cannot be set because it was not declared"),
    ('param set /turtlesim start_type_description_service false', 0,
     "Setting parameter failed: parameter 'start_type_description_service' cannot be set because it is read-only"),
    ('topic info /nothing', 1, "Unknown topic '/nothing'"),
    ('topic pub --once /x std_msgs/msg/Strin', 1, 'The passed message type is invalid'),
    ('topic pub --once -w 0 /x std_msgs/msg/String "{dat: 1}"', 1,
     "Failed to populate field: 'String' object has no attribute 'dat'"),
    ('topic echo /nothing', 1, 'Could not determine the type for the passed topic'),
    ('topic echo --once --field nothing /turtle1/pose', 1,
     "Invalid field 'nothing': 'Pose' object has no attribute 'nothing'"),
    ('topic pub --once --max-wait-time-secs 0.5 /x std_msgs/msg/String', 1,
     'Timed out waiting for subscribers: Expected 1 subcribers but only got 0 subscribers'),
    ('node info /nothing', 1, "Unable to find node '/nothing'"),
    ('param list /nothing', 1, 'Node not found'),
    ('param get /turtlesim nothing', 1, 'Parameter not set'),
    ('param load /turtlesim', 2, 'ros2 param load: error: the following arguments are required: parameter_file'),
    ('param load /nothing nothing.yaml', 1, 'Node not found'),
    ('lifecycle get /nothing', 1, 'Node not found'),
    ('interface show nothing/msg/Nothing', 1, "Unknown package 'nothing'"),
    ('pkg prefix nothing', 1, 'Package not found'),
    ('pkg create', 2, 'ros2 pkg create: error: the following arguments are required: package_name'),
    ('launch turtlesim', 1, 'No launch file supplied'),
    ('launch nothing.launch.py', 1, 'No launch file supplied'),
    ('bag record --topics /pose --exclude-topics /pose', 1,
     '[ERROR] [ros2bag]: --exclude-topics argument requires either --all, --all-topics, --topic-types or --regex'),
    ('bag record --all --compression-format zstd', 1,
     '[ERROR] [ros2bag]: Invalid choice: Cannot specify compression format without a compression mode.'),
    ('component types nothing', 1, "Unable to find package 'nothing'"),
    ('component standalone composition composition::Talker', 1, "Package 'rclcpp_components' not found"),
    ('run nothing nothing', 1, "Package 'nothing' not found"),
    ('run turtlesim nothing', 1, 'No executable found'),
]  # fmt: skip


@pytest.mark.usefixtures('turtlesim')
@pytest.mark.one_of(5)
@pytest.mark.parametrize('line,pattern', LINES, ids=[line for line, _ in LINES])
def test_command_line(ros2, line, pattern):  # noqa: F811
    done = run_line(ros2, line)
    assert done.returncode == 0, done
    assert re.fullmatch(pattern, done.stdout), done.stdout


@pytest.mark.one_of(5)
@pytest.mark.usefixtures('turtlesim')
@pytest.mark.parametrize('line,status,said', REFUSED, ids=[line for line, _, _ in REFUSED])
def test_refused_line(ros2, line, status, said):  # noqa: F811
    done = run_line(ros2, line)
    assert done.returncode == status, done
    assert (done.stdout + done.stderr).splitlines()[-1] == said
    assert 'Traceback' not in done.stderr


@pytest.mark.one_of(2)
def test_parameters_of_a_file_for_all_nodes(ros2, turtlesim):  # noqa: F811
    (ros2.directory / 'all.yaml').write_text('/**:\n  ros__parameters:\n    background_r: 7\n')
    assert ros2.output('param', 'load', '/turtlesim', 'all.yaml') == 'Set parameter background_r successful\n'
    assert ros2.output('param', 'get', '/turtlesim', 'background_r') == 'Integer value is: 7\n'
    refused = ros2.error('param', 'load', '/turtlesim', 'all.yaml', '--no-use-wildcard')
    assert refused.startswith('Param file does not contain parameters for /turtlesim')


MONITOR = """
import rclpy
from rclpy.node import Node
from rclpy.parameter import parameter_value_to_python
from rclpy.parameter_event_handler import ParameterEventHandler


class Monitor(Node):
    def __init__(self):
        super().__init__('monitor')
        self.declare_parameter('own', 0)
        self.handler = ParameterEventHandler(self)
        self.kept = [
            self.handler.add_parameter_callback(parameter_name=name, node_name=node, callback=self.tell)
            for name, node in (('own', 'monitor'), ('background_r', 'turtlesim'))
        ]
        print('listening', flush=True)

    def tell(self, parameter):
        self.get_logger().info(f'{parameter.name} is {parameter_value_to_python(parameter.value)}')


rclpy.init()
rclpy.spin(Monitor())
"""


@pytest.mark.one_of(2)
def test_changes_of_parameters_are_monitored(ros2, turtlesim):  # noqa: F811
    """Monitoring for parameter changes (Python): a node's own parameter, and one of another node."""
    (ros2.directory / 'monitor.py').write_text(MONITOR)
    with background([sys.executable, 'monitor.py'], env=with_programs(ros2), cwd=ros2.directory) as monitor:
        monitor.wait_for_output('listening', PATIENCE)
        for node, name, value in (('monitor', 'own', '43'), ('/turtlesim', 'background_r', '12')):
            assert ros2.output('param', 'set', node, name, value) == 'Set parameter successful\n'
            monitor.wait_for_output(f'[monitor]: {name} is {value}', PATIENCE)


ACTION_SERVER = """
import time

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node


class Numbers(Node):
    def __init__(self):
        super().__init__('fibonacci_action_server')
        self.declare_parameter('succeeds', True)
        self.server = ActionServer(self, Fibonacci, 'fibonacci', self.count)
        self.get_logger().info('offered')

    def count(self, goal_handle):
        self.get_logger().info('Executing goal...')
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        end = time.monotonic() + 10.0  # a client may send its goal before its subscription is known here
        while not self.count_subscribers('fibonacci/_action/feedback') and time.monotonic() < end:
            time.sleep(0.01)
        for _ in range(1, goal_handle.request.order):
            feedback.sequence.append(sum(feedback.sequence[-2:]))
            goal_handle.publish_feedback(feedback)
            time.sleep(0.1)  # as long as its work takes; the tutorial's takes a second
        if self.get_parameter('succeeds').value:
            goal_handle.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)


rclpy.init()
rclpy.spin(Numbers())
"""

ACTION_CLIENT = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node


class Asker(Node):
    def __init__(self):
        super().__init__('fibonacci_action_client')
        self.client = ActionClient(self, Fibonacci, 'fibonacci')

    def ask(self, order):
        self.client.wait_for_server()
        sent = self.client.send_goal_async(Fibonacci.Goal(order=order), feedback_callback=self.hear)
        sent.add_done_callback(self.answered)

    def hear(self, message):
        self.get_logger().info(f'Received feedback: {list(message.feedback.sequence)}')

    def answered(self, future):
        self.get_logger().info('Goal accepted' if future.result().accepted else 'Goal rejected')
        future.result().get_result_async().add_done_callback(self.done)

    def done(self, future):
        self.get_logger().info(f'Result: {list(future.result().result.sequence)}')
        rclpy.shutdown()


rclpy.init()
asker = Asker()
asker.ask(10)
rclpy.spin(asker)
"""


@pytest.mark.one_of(2)
def test_an_action_is_served_and_called(ros2):  # noqa: F811
    """Writing an action server and client (Python): a goal that nobody ended, one that succeeded, and a client."""
    (ros2.directory / 'action_server.py').write_text(ACTION_SERVER)
    (ros2.directory / 'action_client.py').write_text(ACTION_CLIENT)
    goal = ('action', 'send_goal', 'fibonacci', 'example_interfaces/action/Fibonacci', '{order: 5}')
    begin = r'Waiting for an action server to become available\.\.\.\nSending goal:\n     order: 5\n\n'
    begin += r'Goal accepted with ID: [0-9a-f]{32}\n\n'
    result = r'Result:\n    sequence:\n- 0\n- 1\n- 1\n- 2\n- 3\n- 5\n\nGoal finished with status: '
    program = {'env': with_programs(ros2), 'cwd': ros2.directory}
    with background([sys.executable, 'action_server.py'], **program) as server:
        server.wait_for_output('offered', PATIENCE)
        assert re.fullmatch(begin + result + 'SUCCEEDED\n', ros2.output(*goal))
        feedback = r'(Feedback:\n    sequence:\n(- \d\n)+\n){1,4}'
        assert re.fullmatch(begin + feedback + result + 'SUCCEEDED\n', ros2.output(*goal, '--feedback'))
        assert ros2.output('action', 'info', '/fibonacci', '-t') == (
            'Action: /fibonacci\nAction clients: 0\nAction servers: 1\n'
            '    /fibonacci_action_server [example_interfaces/action/Fibonacci]\n'
        )
        with background([sys.executable, 'action_client.py'], **program) as client:
            client.wait_for_output('[fibonacci_action_client]: Goal accepted', PATIENCE)
            client.wait_for_output('Received feedback: [0, 1, 1', PATIENCE)
            client.wait_for_output('Result: [0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55]', PATIENCE)
        assert ros2.output('param', 'set', 'fibonacci_action_server', 'succeeds', 'false')
        assert re.fullmatch(begin + result + 'ABORTED\n', ros2.output(*goal))
        server.wait_for_output('Goal state not set, assuming aborted. Goal ID:', PATIENCE)


@pytest.mark.one_of(2)
def test_a_turtle_is_recorded_and_played(ros2, turtlesim):  # noqa: F811
    """Recording and playing back data."""
    with ros2.start('bag', 'record', '-o', 'subset', '/turtle1/cmd_vel', '/turtle1/pose') as recorder:
        recorder.wait_for_output("Subscribed to topic '/turtle1/pose'", PATIENCE)
        with ros2.start(
            'topic', 'pub', '-r', '10', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 1.0}}'
        ):
            recorder.wait_for_output("Subscribed to topic '/turtle1/cmd_vel'", PATIENCE)
            recorder.wait_for_output('All requested topics are subscribed. Stopping discovery...', PATIENCE)
            assert ros2.output('topic', 'echo', '--once', '/turtle1/cmd_vel').startswith('linear:\n  x: 1.0\n')
        assert recorder.stop(PATIENCE) == 0
    told = ros2.output('bag', 'info', 'subset')
    assert re.search(r'Topic: /turtle1/cmd_vel \| Type: geometry_msgs/msg/Twist \| Count: [1-9]', told)
    assert re.search(r'Topic: /turtle1/pose \| Type: turtlesim/msg/Pose \| Count: [1-9]', told)
    with ros2.start('topic', 'echo', '--once', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist') as echo:
        played = ros2.run('bag', 'play', 'subset', '--rate', '5', '--delay', '1', '--disable-keyboard-controls')
        assert played.returncode == 0, played
        echo.wait_for_output('x: 1.0', PATIENCE)


def test_doctor_warns_of_publishers_that_nobody_hears(ros2, turtlesim):  # noqa: F811
    """Using ros2doctor, checking a system: a warning for each topic of the turtle, until it is echoed."""

    def warnings():
        done = run_line(ros2, 'doctor')
        assert (done.returncode, done.stdout) == (0, '\nAll 5 checks passed\n\n'), done
        return set(re.findall(r'UserWarning: Publisher without subscriber detected on (\S+)\.$', done.stderr, re.M))

    assert {'/turtle1/color_sensor', '/turtle1/pose'} <= warnings()
    with ros2.start('topic', 'echo', '/turtle1/pose') as echo:
        echo.wait_for_output('theta: ', PATIENCE)
        heard = warnings()
    assert '/turtle1/color_sensor' in heard and '/turtle1/pose' not in heard
