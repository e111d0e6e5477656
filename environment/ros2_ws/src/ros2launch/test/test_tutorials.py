"""
The launch files of upstream's launch tutorials, in Python, XML and YAML, and one for each thing they show.

The texts are our own; packages, programs, topics and steps are those of the tutorials. The turtle has no window here.
"""

import os
import re
import signal
import textwrap
from pathlib import Path

import pytest
from geometry_msgs.msg import Twist
from rcl_interfaces.srv import GetParameters
from turtlesim.msg import Pose

from environment.tests.running import PATIENCE, ROS2

pytestmark = [pytest.mark.early, pytest.mark.timeout(240)]

FORMATS = ['py', 'xml', 'yaml']
LONG = 2 * PATIENCE  # seconds for several programs that start one another


@pytest.fixture
def package(tmp_path, monkeypatch):
    """An installed package launch_tutorial; ``package(name, text)`` adds a file and returns its path."""
    share = tmp_path / 'install' / 'share'
    index = share / 'ament_index' / 'resource_index' / 'packages'
    index.mkdir(parents=True)
    (index / 'launch_tutorial').touch()
    monkeypatch.setenv('AMENT_PREFIX_PATH', f'{tmp_path / "install"}:{os.environ["AMENT_PREFIX_PATH"]}')
    monkeypatch.setenv('PATH', f'{Path(ROS2).parent}:{os.environ["PATH"]}')  # for launch files that call ros2
    monkeypatch.setenv('DISPLAY', '')
    monkeypatch.setenv('USER', 'learner')

    def add(name: str, text: str) -> Path:
        path = share / 'launch_tutorial' / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(textwrap.dedent(text).lstrip('\n'))
        return path

    return add


def parameter(peer, node, name):
    return peer.call(GetParameters, f'{node}/get_parameters', names=[name]).values[0].integer_value


# --- Creating a launch file: one turtle mimics another ------------------------------------------------------------

MIMIC = {
    'py': """
        from launch import LaunchDescription
        from launch_ros.actions import Node


        def generate_launch_description():
            worlds = [Node(package='turtlesim', namespace=name, executable='turtlesim_node', name='sim')
                      for name in ('turtlesim1', 'turtlesim2')]
            mimic = Node(package='turtlesim', executable='mimic', name='mimic', remappings=[
                ('/input/pose', '/turtlesim1/turtle1/pose'), ('/output/cmd_vel', '/turtlesim2/turtle1/cmd_vel')])
            return LaunchDescription([*worlds, mimic])
        """,
    'xml': """
        <launch>
          <node pkg="turtlesim" exec="turtlesim_node" name="sim" namespace="turtlesim1"/>
          <node pkg="turtlesim" exec="turtlesim_node" name="sim" namespace="turtlesim2"/>
          <node pkg="turtlesim" exec="mimic" name="mimic">
            <remap from="/input/pose" to="/turtlesim1/turtle1/pose"/>
            <remap from="/output/cmd_vel" to="/turtlesim2/turtle1/cmd_vel"/>
          </node>
        </launch>
        """,
    'yaml': """
        launch:
          - node: {pkg: turtlesim, exec: turtlesim_node, name: sim, namespace: turtlesim1}
          - node: {pkg: turtlesim, exec: turtlesim_node, name: sim, namespace: turtlesim2}
          - node:
              pkg: turtlesim
              exec: mimic
              name: mimic
              remap:
                - from: /input/pose
                  to: /turtlesim1/turtle1/pose
                - from: /output/cmd_vel
                  to: /turtlesim2/turtle1/cmd_vel
        """,
}


@pytest.mark.parametrize('kind', FORMATS)
def test_one_turtle_mimics_another(package, start, peer, kind):
    path = package(f'launch/turtlesim_mimic_launch.{kind}', MIMIC[kind])
    process = start(ROS2, 'launch', str(path))
    poses = peer.listen(Pose, '/turtlesim2/turtle1/pose')
    publisher = peer.publisher(Twist, '/turtlesim1/turtle1/cmd_vel')
    peer.until(lambda: poses, 'a pose of the second turtle', LONG)
    begin = poses[0].x
    command = Twist()
    command.linear.x = 2.0

    def moved():
        publisher.publish(command)
        return abs(poses[-1].x - begin) > 0.5

    peer.until(moved, 'the second turtle to move', LONG)
    assert process.stop(timeout=PATIENCE) == 0


# --- Using substitutions: a file includes another and gives it arguments ------------------------------------------

SUBSTITUTIONS = {
    'py': """
        from launch import LaunchDescription
        from launch.actions import DeclareLaunchArgument, ExecuteProcess, TimerAction
        from launch.conditions import IfCondition
        from launch.substitutions import LaunchConfiguration, PythonExpression
        from launch_ros.actions import Node


        def generate_launch_description():
            ns, red = LaunchConfiguration('turtlesim_ns'), LaunchConfiguration('new_background_r')
            use = LaunchConfiguration('use_provided_red')
            spawn = ExecuteProcess(cmd=[['ros2 service call ', ns, '/spawn turtlesim/srv/Spawn ',
                                         '"{x: 2, y: 2, theta: 0.2}"']], shell=True)
            first = ExecuteProcess(cmd=[['ros2 param set ', ns, '/sim background_r 120']], shell=True)
            second = ExecuteProcess(condition=IfCondition(PythonExpression([red, ' == 200 and ', use])),
                                    cmd=[['ros2 param set ', ns, '/sim background_r ', red]], shell=True)
            return LaunchDescription([
                DeclareLaunchArgument('turtlesim_ns', default_value='turtlesim1'),
                DeclareLaunchArgument('use_provided_red', default_value='False'),
                DeclareLaunchArgument('new_background_r', default_value='200'),
                Node(package='turtlesim', namespace=ns, executable='turtlesim_node', name='sim'),
                spawn, first, TimerAction(period=2.0, actions=[second]),
            ])
        """,
    'xml': """
        <launch>
          <arg name="turtlesim_ns" default="turtlesim1"/>
          <arg name="use_provided_red" default="False"/>
          <arg name="new_background_r" default="200"/>
          <node pkg="turtlesim" namespace="$(var turtlesim_ns)" exec="turtlesim_node" name="sim"/>
          <executable
            cmd="ros2 service call $(var turtlesim_ns)/spawn turtlesim/srv/Spawn '{x: 2, y: 2, theta: 0.2}'"/>
          <executable cmd="ros2 param set $(var turtlesim_ns)/sim background_r 120"/>
          <timer period="2.0">
            <executable cmd="ros2 param set $(var turtlesim_ns)/sim background_r $(var new_background_r)"
                        if="$(eval '$(var new_background_r) == 200 and $(var use_provided_red)')"/>
          </timer>
        </launch>
        """,
    'yaml': """
        %YAML 1.2
        ---
        launch:
          - arg: {name: "turtlesim_ns", default: "turtlesim1"}
          - arg: {name: "use_provided_red", default: "False"}
          - arg: {name: "new_background_r", default: "200"}
          - node: {pkg: "turtlesim", namespace: "$(var turtlesim_ns)", exec: "turtlesim_node", name: "sim"}
          - executable:
              cmd: 'ros2 service call $(var turtlesim_ns)/spawn turtlesim/srv/Spawn "{x: 2, y: 2, theta: 0.2}"'
          - executable:
              cmd: "ros2 param set $(var turtlesim_ns)/sim background_r 120"
          - timer:
              period: 2.0
              children:
                - executable:
                    cmd: "ros2 param set $(var turtlesim_ns)/sim background_r $(var new_background_r)"
                    if: '$(eval "$(var new_background_r) == 200 and $(var use_provided_red)")'
        """,
}
MAIN = {
    'py': """
        from launch import LaunchDescription
        from launch.actions import IncludeLaunchDescription
        from launch.launch_description_sources import PythonLaunchDescriptionSource
        from launch.substitutions import PathJoinSubstitution, TextSubstitution
        from launch_ros.substitutions import FindPackageShare


        def generate_launch_description():
            path = PathJoinSubstitution([
                FindPackageShare('launch_tutorial'), 'launch', 'example_substitutions_launch.py'])
            return LaunchDescription([IncludeLaunchDescription(
                PythonLaunchDescriptionSource([path]),
                launch_arguments={'turtlesim_ns': 'turtlesim2', 'use_provided_red': 'True',
                                  'new_background_r': TextSubstitution(text='200')}.items())])
        """,
    'xml': """
        <launch>
          <let name="background_r" value="200"/>
          <include file="$(find-pkg-share launch_tutorial)/launch/example_substitutions_launch.xml">
            <let name="turtlesim_ns" value="turtlesim2"/>
            <let name="use_provided_red" value="True"/>
            <let name="new_background_r" value="$(var background_r)"/>
          </include>
        </launch>
        """,
    'yaml': """
        %YAML 1.2
        ---
        launch:
          - let:
              name: 'background_r'
              value: '200'
          - include:
              file: '$(find-pkg-share launch_tutorial)/launch/example_substitutions_launch.yaml'
              let:
                - {name: 'turtlesim_ns', value: 'turtlesim2'}
                - {name: 'use_provided_red', value: 'True'}
                - {name: 'new_background_r', value: '$(var background_r)'}
        """,
}


@pytest.mark.parametrize('kind', FORMATS)
def test_a_file_gives_arguments_to_another(package, start, peer, kind):
    package(f'launch/example_substitutions_launch.{kind}', SUBSTITUTIONS[kind])
    package(f'launch/example_main_launch.{kind}', MAIN[kind])
    process = start(ROS2, 'launch', 'launch_tutorial', f'example_main_launch.{kind}')
    peer.until(lambda: peer.node.count_publishers('/turtlesim2/turtle2/pose'), 'the second turtle', LONG)
    peer.until(lambda: parameter(peer, '/turtlesim2/sim', 'background_r') == 200, 'the new background', LONG)
    assert process.stop(timeout=PATIENCE) == 0


# --- Using event handlers -----------------------------------------------------------------------------------------

EVENTS = """
    from launch import LaunchDescription
    from launch.actions import (
        DeclareLaunchArgument, EmitEvent, ExecuteProcess, LogInfo, RegisterEventHandler, TimerAction)
    from launch.conditions import IfCondition
    from launch.event_handlers import (
        OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown)
    from launch.events import Shutdown
    from launch.substitutions import (
        EnvironmentVariable, FindExecutable, LaunchConfiguration, LocalSubstitution, PythonExpression)
    from launch_ros.actions import Node


    def generate_launch_description():
        ns, red = LaunchConfiguration('turtlesim_ns'), LaunchConfiguration('new_background_r')
        use = LaunchConfiguration('use_provided_red')
        ros2 = FindExecutable(name='ros2')
        sim = Node(package='turtlesim', namespace=ns, executable='turtlesim_node', name='sim')
        spawn = ExecuteProcess(cmd=[[ros2, ' service call ', ns, '/spawn turtlesim/srv/Spawn ',
                                     '"{x: 2, y: 2, theta: 0.2}"']], shell=True)
        first = ExecuteProcess(cmd=[[ros2, ' param set ', ns, '/sim background_r 120']], shell=True)
        second = ExecuteProcess(condition=IfCondition(PythonExpression([red, ' == 200', ' and ', use])),
                                cmd=[[ros2, ' param set ', ns, '/sim background_r ', red]], shell=True)
        return LaunchDescription([
            DeclareLaunchArgument('turtlesim_ns', default_value='turtlesim1'),
            DeclareLaunchArgument('use_provided_red', default_value='False'),
            DeclareLaunchArgument('new_background_r', default_value='200'),
            sim,
            RegisterEventHandler(OnProcessStart(
                target_action=sim, on_start=[LogInfo(msg='Turtlesim started, spawning turtle'), spawn])),
            RegisterEventHandler(OnProcessIO(target_action=spawn, on_stdout=lambda event: LogInfo(
                msg=f'Spawn request says "{event.text.decode().strip()}"'))),
            RegisterEventHandler(OnExecutionComplete(target_action=spawn, on_completion=[
                LogInfo(msg='Spawn finished'), first, TimerAction(period=2.0, actions=[second])])),
            RegisterEventHandler(OnProcessExit(target_action=sim, on_exit=[
                LogInfo(msg=(EnvironmentVariable(name='USER'), ' closed the turtlesim window')),
                EmitEvent(event=Shutdown(reason='Window closed'))])),
            RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(
                msg=['Launch was asked to shutdown: ', LocalSubstitution('event.reason')])])),
        ])
    """


def test_the_event_handlers_lead_through_the_whole_story(package, start, peer):
    package('launch/example_event_handlers_launch.py', EVENTS)
    process = start(
        ROS2,
        'launch',
        'launch_tutorial',
        'example_event_handlers_launch.py',
        'turtlesim_ns:=turtlesim3',
        'use_provided_red:=True',
        'new_background_r:=200',
    )
    for text in ('Turtlesim started, spawning turtle', 'Spawn request says "', "name='turtle2')", 'Spawn finished'):
        process.wait_for_output(text, timeout=LONG)
    peer.until(lambda: parameter(peer, '/turtlesim3/sim', 'background_r') == 200, 'the new background', LONG)
    pid = int(re.search(r'\[turtlesim_node-1\]: process started with pid \[(\d+)\]', process.output).group(1))
    os.kill(pid, signal.SIGINT)  # as closing the window
    process.wait_for_output('[INFO] [launch.user]: learner closed the turtlesim window', timeout=LONG)
    process.wait_for_output('[INFO] [launch.user]: Launch was asked to shutdown: Window closed', timeout=LONG)
    assert process._popen.wait(LONG) == 0


# --- Managing large projects, and the three formats compared ------------------------------------------------------

WORLD = {
    'xml': """
        <launch>
          <arg name="background_r" default="10"/>
          <arg name="ns" default="none"/>
          <node pkg="turtlesim" exec="turtlesim_node" name="sim" namespace="$(var ns)">
            <param from="$(find-pkg-share launch_tutorial)/config/turtlesim.yaml"/>
            <param name="background_r" value="$(var background_r)"/>
          </node>
        </launch>
        """,
    'yaml': """
        launch:
          - arg: {name: background_r, default: "10"}
          - arg: {name: ns, default: none}
          - node:
              pkg: turtlesim
              exec: turtlesim_node
              name: sim
              namespace: $(var ns)
              param:
                - from: $(find-pkg-share launch_tutorial)/config/turtlesim.yaml
                - name: background_r
                  value: $(var background_r)
        """,
    'py': """
        from launch import LaunchDescription
        from launch.actions import DeclareLaunchArgument
        from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
        from launch_ros.actions import Node
        from launch_ros.substitutions import FindPackageShare


        def generate_launch_description():
            config = PathJoinSubstitution([FindPackageShare('launch_tutorial'), 'config', 'turtlesim.yaml'])
            return LaunchDescription([
                DeclareLaunchArgument('background_r', default_value='10'),
                DeclareLaunchArgument('ns', default_value='none'),
                Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace=LaunchConfiguration('ns'),
                     parameters=[config, {'background_r': LaunchConfiguration('background_r')}]),
            ])
        """,
}
CONFIG = """
    /**:
      ros__parameters:
        background_b: 255
        background_g: 86
    """
GROUPS = {
    'xml': """
        <launch>
          <arg name="background_r" default="20"/>
          <group>
            <push_ros_namespace namespace="left"/>
            <include file="$(dirname)/world_launch.KIND"><arg name="ns" value="a"/></include>
          </group>
          <group>
            <push-ros-namespace namespace="right"/>
            <set_parameter name="holonomic" value="true"/>
            <set_remap from="turtle1/pose" to="where"/>
            <include file="$(find-pkg-share launch_tutorial)/launch/world_launch.KIND">
              <arg name="ns" value="b"/>
              <arg name="background_r" value="30"/>
            </include>
          </group>
        </launch>
        """,
    'yaml': """
        launch:
          - arg: {name: background_r, default: "20"}
          - group:
              - push_ros_namespace: {namespace: left}
              - include:
                  file: $(dirname)/world_launch.KIND
                  arg: [{name: ns, value: a}]
          - group:
              - push-ros-namespace: {namespace: right}
              - set_parameter: {name: holonomic, value: true}
              - set_remap: {from: turtle1/pose, to: where}
              - include:
                  file: $(find-pkg-share launch_tutorial)/launch/world_launch.KIND
                  arg:
                    - {name: ns, value: b}
                    - {name: background_r, value: "30"}
        """,
    'py': """
        from launch import LaunchDescription
        from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
        from launch.substitutions import PathJoinSubstitution, TextSubstitution
        from launch_ros.actions import PushROSNamespace, SetParameter, SetRemap
        from launch_ros.substitutions import FindPackageShare
        from launch_xml.launch_description_sources import XMLLaunchDescriptionSource
        from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource

        SOURCES = {'xml': XMLLaunchDescriptionSource, 'yaml': YAMLLaunchDescriptionSource}


        def world(**arguments):
            path = PathJoinSubstitution([FindPackageShare('launch_tutorial'), 'launch', 'world_launch.KIND'])
            return IncludeLaunchDescription(SOURCES['KIND'](path), launch_arguments=arguments.items())


        def generate_launch_description():
            return LaunchDescription([
                DeclareLaunchArgument('background_r', default_value=TextSubstitution(text='20')),
                GroupAction([PushROSNamespace('left'), world(ns='a')]),
                GroupAction([
                    PushROSNamespace('right'), SetParameter('holonomic', True), SetRemap('turtle1/pose', 'where'),
                    world(ns='b', background_r='30')]),
            ])
        """,
}


@pytest.mark.parametrize(
    'outer, inner', [('xml', 'yaml'), ('yaml', 'py'), ('xml', 'xml'), ('py', 'xml'), ('py', 'yaml')]
)
def test_groups_have_namespaces_parameters_and_remappings(package, start, peer, outer, inner):
    package('config/turtlesim.yaml', CONFIG)
    package(f'launch/world_launch.{inner}', WORLD[inner])
    package(f'launch/all_launch.{outer}', GROUPS[outer].replace('KIND', inner))
    process = start(ROS2, 'launch', 'launch_tutorial', f'all_launch.{outer}', 'background_r:=40')
    peer.until(lambda: peer.node.count_publishers('/left/a/turtle1/pose'), 'the turtle on the left', LONG)
    peer.until(lambda: peer.node.count_publishers('/right/b/where'), 'the turtle on the right', LONG)
    values = [
        parameter(peer, node, f'background_{colour}') for node in ('/left/a/sim', '/right/b/sim') for colour in 'rgb'
    ]
    assert values == [40, 86, 255, 30, 86, 255]
    holonomic = peer.call(GetParameters, '/right/b/sim/get_parameters', names=['holonomic']).values[0]
    assert holonomic.bool_value
    assert process.stop(timeout=PATIENCE) == 0


def test_arguments_of_an_xml_file_are_shown(package, start):
    package('launch/world_launch.xml', WORLD['xml'])
    process = start(ROS2, 'launch', 'launch_tutorial', 'world_launch.xml', '--show-args')
    process.wait_for_output("(default: 'none')", timeout=LONG)
    assert process._popen.wait(PATIENCE) == 0
    assert "'background_r':\n        no description given\n        (default: '10')" in process.output
