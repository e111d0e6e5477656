"""A container is asked to load nodes; here it is a program in Python that prints what it is asked for."""

import io
import json
import os
import subprocess
import sys
from pathlib import Path

import launch_ros.actions
import pytest
from launch import LaunchContext, LaunchDescription, LaunchService
from launch.conditions import IfCondition
from launch.frontend import Parser
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes
from launch_ros.descriptions import ComposableNode

from environment.tests.running import PATIENCE, ROS2
from helpers.programs.processes import background

pytestmark = [pytest.mark.early, pytest.mark.timeout(300)]  # its workspace takes more than a minute to build

PACKAGE_XML = """<package format="3">
  <name>composition_interfaces</name>
  <version>2.0.3</version>
  <description>Services of containers.</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <depend>rcl_interfaces</depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.5)
project(composition_interfaces)
find_package(ament_cmake REQUIRED)
find_package(rcl_interfaces REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "srv/LoadNode.srv" DEPENDENCIES rcl_interfaces)
ament_package()
"""
LOAD_NODE = """string package_name
string plugin_name
string node_name
string node_namespace
uint8 log_level
string[] remap_rules
rcl_interfaces/Parameter[] parameters
rcl_interfaces/Parameter[] extra_arguments
---
bool success
string error_message
string full_node_name
uint64 unique_id
"""
CONTAINER = """
import json

import rclpy
from composition_interfaces.srv import LoadNode
from rclpy.executors import ExternalShutdownException
from rclpy.parameter import parameter_value_to_python


def load(request, response):
    def plain(parameters):
        return [[each.name, parameter_value_to_python(each.value)] for each in parameters]

    print(json.dumps({
        'what': [request.package_name, request.plugin_name, request.node_namespace, request.node_name],
        'remap_rules': list(request.remap_rules),
        'parameters': plain(request.parameters),
        'extra_arguments': plain(request.extra_arguments),
    }), flush=True)
    response.success = request.plugin_name != 'p::Broken'
    response.error_message = '' if response.success else 'no such class'
    response.full_node_name = f'{request.node_namespace}/{request.node_name}' if response.success else ''
    return response


rclpy.init()
node = rclpy.create_node('unnamed')
node.create_service(LoadNode, '~/_container/load_node', load)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""
PARAMETERS = """
/front:
  /camera:
    ros__parameters:
      own: 1
      both: own
/**:
  ros__parameters:
    both: every
    group: {part: 2.5}
/*/lidar:
  ros__parameters: {other: true}
"""
LAUNCH_FILE = """
import sys

from launch import LaunchDescription
from launch.actions import GroupAction, RegisterEventHandler, Shutdown
from launch.conditions import IfCondition
from launch.event_handlers import OnExecutionComplete, OnProcessIO
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes, PushROSNamespace, SetParameter, SetRemap
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    container = ComposableNodeContainer(
        executable=sys.executable, arguments=['container.py'], name='box', namespace='/tools', output='screen',
        composable_node_descriptions=[
            ComposableNode(package='p', plugin='p::Broken', name='first'),
            ComposableNode(package='p', plugin='p::Never', condition=IfCondition('false')),
        ],
    )
    later = LoadComposableNodes(
        target_container='/tools/box',
        composable_node_descriptions=[
            ComposableNode(
                package='p', plugin='p::Camera', name='camera', namespace='front',
                parameters=['parameters.yaml', {'fast': True, 'group': {'part': 3}}],
                remappings=[('image', 'picture')], extra_arguments=[{'use_intra_process_comms': True}],
            ),
            ComposableNode(package='p', plugin='p::Camera', name='camera', namespace='front'),
        ],
    )
    group = GroupAction([PushROSNamespace('robot'), SetRemap('a', 'b'), SetParameter('all', 'of them'), later])
    return LaunchDescription([
        container,
        RegisterEventHandler(OnProcessIO(
            target_action=container, on_stdout=lambda event: group if b'p::Broken' in event.text else None,
        )),
        RegisterEventHandler(OnExecutionComplete(target_action=later, on_completion=[Shutdown(reason='loaded')])),
    ])
"""


@pytest.fixture(scope='module')
def workspace(tmp_path_factory):
    """A workspace with the services of containers, built."""
    root = tmp_path_factory.mktemp('workspace')
    package = root / 'src' / 'composition_interfaces'
    (package / 'srv').mkdir(parents=True)
    (package / 'package.xml').write_text(PACKAGE_XML)
    (package / 'CMakeLists.txt').write_text(CMAKE)
    (package / 'srv' / 'LoadNode.srv').write_text(LOAD_NODE)
    built = subprocess.run(
        [sys.executable, '-m', 'colcon', '--log-base', '/dev/null', 'build'],
        cwd=root,
        env={**os.environ, 'PATH': f'{Path(sys.executable).parent}{os.pathsep}{os.environ["PATH"]}'},  # has CMake
        capture_output=True,
        text=True,
        timeout=240,
    )
    assert built.returncode == 0, built
    for name, text in (('container.py', CONTAINER), ('parameters.yaml', PARAMETERS), ('a.launch.py', LAUNCH_FILE)):
        (root / name).write_text(text)
    return root


def test_a_container_is_asked_to_load_what_the_launch_file_says(workspace, domain):
    command = f'source install/setup.bash && exec {ROS2} launch a.launch.py --noninteractive'
    with background(['bash', '-c', command], cwd=workspace) as launched:
        launched.wait_for_output('process has finished cleanly', 2 * PATIENCE)
    lines = [line.partition('] ')[2] for line in launched.output.splitlines()]
    first, camera, again = (json.loads(line) for line in lines if line.startswith('{'))
    assert first['what'] == ['p', 'p::Broken', '', 'first'] and first['parameters'] == []
    # the node's own section comes before the one for every node, which therefore wins, as in the file of any node
    assert camera == {
        'what': ['p', 'p::Camera', '/robot/front', 'camera'],
        'remap_rules': ['a:=b', 'image:=picture'],
        'parameters': [
            ['all', 'of them'], ['both', 'every'], ['group.part', 2.5], ['fast', True], ['group.part', 3],
        ],
        'extra_arguments': [['use_intra_process_comms', True]],
    }  # fmt: skip
    assert again['what'] == camera['what'] and again['extra_arguments'] == []
    text = launched.output
    assert "Failed to load node 'first' of type 'p::Broken' in container '/tools/box': no such class" in text
    assert text.count("Loaded node '/robot/front/camera' in container '/tools/box'") == 2
    assert 'there are now at least 2 nodes with the name /robot/front/camera created within this' in text


def test_a_container_is_written_in_xml():
    text = """<launch><node_container pkg="p" exec="container" name="box" namespace="">
      <composable_node pkg="c" plugin="c::A" name="a" namespace="n" unless="false">
        <param name="x"><param name="y" value="1"/></param><remap from="i" to="j"/>
        <extra_arg name="use_intra_process_comms" value="true"/>
      </composable_node></node_container>
      <load_composable_node target="/box"><composable_node pkg="c" plugin="c::B" name="b"/></load_composable_node>
    </launch>"""
    root, parser = Parser.load(io.StringIO(text))
    container, load = parser.parse_description(root).entities
    assert type(container) is ComposableNodeContainer and type(load) is LoadComposableNodes
    description, kwargs = ComposableNode.parse(parser, root.children[0].children[0])
    one = description(**kwargs)
    fields = one.request_fields(LaunchContext())
    assert one.is_wanted(LaunchContext()) and fields.pop('parameters')[0].name == 'x.y'
    assert fields.pop('extra_arguments')[0].value.bool_value
    assert fields == {
        'package_name': 'c', 'plugin_name': 'c::A', 'node_name': 'a', 'node_namespace': '/n', 'remap_rules': ['i:=j'],
    }  # fmt: skip
    with pytest.raises(ValueError, match='colour'):
        root, parser = Parser.load(io.StringIO(text.replace('plugin="c::B"', 'plugin="c::B" colour="red"')))
        parser.parse_description(root)


def error_of(capsys, *actions):
    """Launch the actions, which must fail; return what is printed."""
    service = LaunchService()
    service.include_launch_description(LaunchDescription(actions))
    assert service.run() == 1
    return capsys.readouterr().out


def test_who_lacks_a_container_or_its_services_is_told_what_to_do(capsys):
    assert hasattr(launch_ros.actions, 'ComposableNodeContainer')
    container = ComposableNodeContainer(
        package='rclcpp_components', executable='component_container', name='box', namespace=''
    )
    said = error_of(capsys, container)
    assert "package 'rclcpp_components' not found" in said and 'with launch_ros.actions.Node' in said
    node = ComposableNode(package='p', plugin='p::P', name='p')
    said = error_of(capsys, LoadComposableNodes(composable_node_descriptions=[node], target_container='/box'))
    assert "needs the package 'composition_interfaces', which is not installed" in said
    with pytest.raises(TypeError, match="'remappings' of Node must be pairs"):
        ComposableNode(package='p', plugin='p::P', remappings=['a'])
    never = ComposableNode(package='p', plugin='p::P', condition=IfCondition('false'))
    service = LaunchService()
    service.include_launch_description(
        LaunchDescription([LoadComposableNodes(composable_node_descriptions=[never], target_container='/box')])
    )
    assert service.run() == 0
