"""What the guide "Migrating launch files" and "different file formats" say of XML and YAML, seen from inside of a node.

The texts are our own. Each node is a program that prints its full name, two environment variables and its parameters.
"""

import os
import sys
import textwrap

import pytest

from environment.tests.running import PATIENCE, ROS2

pytestmark = [pytest.mark.early, pytest.mark.timeout(240)]

PROBE = """\
import os
import rclpy

rclpy.init()
node = rclpy.create_node('probe', automatically_declare_parameters_from_overrides=True)
print('name', node.get_fully_qualified_name(), os.environ.get('OUTER'), os.environ.get('INNER'))
for name, parameter in node._parameters.items():
    value = parameter.value
    print('parameter', name, repr(value.tolist() if hasattr(value, 'tolist') else value))
rclpy.shutdown()
"""


@pytest.fixture
def launched(tmp_path, monkeypatch, start):
    """Launch a text of a format with arguments; return the lines that are printed until the launch ends."""
    program = tmp_path / 'install' / 'lib' / 'probe' / 'probe'
    index = tmp_path / 'install' / 'share' / 'ament_index' / 'resource_index' / 'packages'
    for folder in (program.parent, index, tmp_path / 'install' / 'share' / 'probe'):
        folder.mkdir(parents=True)
    (index / 'probe').touch()
    program.write_text(f'#!{sys.executable}\n{PROBE}')
    program.chmod(0o755)
    monkeypatch.setenv('AMENT_PREFIX_PATH', f'{tmp_path / "install"}:{os.environ["AMENT_PREFIX_PATH"]}')
    monkeypatch.delenv('NOT_SET', raising=False)

    def launch(kind: str, text: str, *arguments: str) -> list[str]:
        path = tmp_path / f'guide_launch.{kind}'
        path.write_text(textwrap.dedent(text).lstrip('\n'))
        process = start(ROS2, 'launch', '-a', str(path), *arguments)
        process._popen.wait(4 * PATIENCE)
        assert process.stop() == 0, process.output
        return [line.partition('] ')[2] if line.startswith('[probe') else line for line in process.lines]

    return launch


def test_values_have_the_types_that_the_guide_says(launched):
    lines = launched(
        'xml',
        r"""
        <launch>
          <node pkg="probe" exec="probe">
            <param name="text" value="'1'"/>
            <param name="whole" value="1"/>
            <param name="real" value="1.0"/>
            <param name="word" value="asd"/>
            <param name="quoted" value="\'asd\'"/>
            <param name="words" value="asd, bsd, csd" value-sep=", "/>
            <param name="numbers" value="1,2,3" value-sep=","/>
            <param name="texts" value="'1'//'2'//'3'" value-sep="//"/>
            <param name="told" value="$(command 'echo hi')"/>
            <param name="group">
              <param name="inner"><param name="deep" value="1"/></param>
              <param name="shallow" value="2"/>
            </param>
            <param name="group.dotted" value="3"/>
          </node>
        </launch>
        """,
    )
    found = dict(line.split(' ', 2)[1:] for line in lines if line.startswith('parameter '))
    expected = {
        'text': '1',
        'whole': 1,
        'real': 1.0,
        'word': 'asd',
        'quoted': "'asd'",
        'words': ['asd', 'bsd', 'csd'],
        'numbers': [1, 2, 3],
        'texts': ['1', '2', '3'],
        'told': 'hi',
        'group.inner.deep': 1,
        'group.shallow': 2,
        'group.dotted': 3,
    }
    assert {name: found.get(name) for name in expected} == {name: repr(value) for name, value in expected.items()}


def test_namespaces_and_environment_belong_to_their_group(launched):
    lines = launched(
        'xml',
        """
        <launch>
          <set_env name="OUTER" value="set" if="true"/>
          <group>
            <push_ros_namespace namespace="my_ns"/>
            <push_ros_namespace namespace="another_ns"/>
            <node pkg="probe" exec="probe" name="nested"><env name="INNER" value="own"/></node>
            <push_ros_namespace namespace="/absolute_ns"/>
            <node pkg="probe" exec="probe" name="absolute"/>
            <node pkg="probe" exec="probe" name="own" namespace="/asd"/>
          </group>
          <unset_env name="OUTER"/>
          <node pkg="probe" exec="probe" name="outside" args="--ros-args --log-level info" ros_args="--log-level warn"/>
        </launch>
        """,
    )
    assert sorted(line for line in lines if line.startswith('name ')) == [
        'name /absolute_ns/absolute set None',
        'name /asd/own set None',
        'name /my_ns/another_ns/nested set own',
        'name /outside None None',
    ]


def test_substitutions_scopes_and_prefixes(launched, tmp_path):
    lines = launched(
        'xml',
        r"""
        <launch>
          <arg name="use_prefix" default="0"/>
          <arg name="which" default="first"/>
          <group>
            <let name="launch-prefix" value="time" if="$(var use_prefix)"/>
            <node pkg="probe" exec="probe" name="timed"/>
          </group>
          <node pkg="probe" exec="probe" name="plain"/>
          <log message="escaped" if="$(eval '\'$(var which)\' == \'first\'')"/>
          <log message="html" unless="$(eval &quot;'$(var which)' == 'first'&quot;)"/>
          <log message="env [$(env NOT_SET '')] [$(env NOT_SET given)]"/>
          <log message="$(find-pkg-prefix probe) $(exec-in-pkg probe probe) $(dirname)"/>
          <group scoped="false"><let name="inside" value="seen"/></group>
          <group><let name="hidden" value="not seen"/></group>
          <log message="$(var inside) $(var hidden nothing)"/>
          <group forwarding="false"><log message="which: $(var which nothing)"/></group>
        </launch>
        """,
        'use_prefix:=1',
    )
    said = [line.partition('[launch.user]: ')[2] for line in lines if '[launch.user]' in line]
    prefix = tmp_path / 'install'
    assert said == [
        'escaped',
        'env [] [given]',
        f'{prefix} {prefix}/lib/probe/probe {tmp_path}',
        'seen nothing',
        'which: nothing',
    ]
    started = {line.split('[')[2].split('-')[0] for line in lines if 'process started' in line}
    assert started == {'time', 'probe'}


@pytest.mark.parametrize('kind', ['py', 'xml', 'yaml'])
def test_files_of_all_formats_are_included_in_namespaces(launched, tmp_path, kind):
    inner = {
        'py': 'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n'
        'def generate_launch_description():\n'
        "    return LaunchDescription([Node(package='probe', executable='probe', name='py')])\n",
        'xml': '<launch><node pkg="probe" exec="probe" name="xml"/></launch>\n',
        'yaml': '%YAML 1.2\n---\nlaunch:\n- node:\n    pkg: "probe"\n    exec: "probe"\n    name: "yaml"\n',
    }
    for ending, text in inner.items():
        (tmp_path / 'install' / 'share' / 'probe' / f'inner_launch.{ending}').write_text(text)
    outer = {
        'py': """
            from launch import LaunchDescription
            from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
            from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
            from launch_ros.actions import PushROSNamespace
            from launch_ros.substitutions import FindPackageShare


            def included(ending):
                file = PathJoinSubstitution([FindPackageShare('probe'), f'inner_launch.{ending}'])
                return GroupAction([PushROSNamespace(LaunchConfiguration('ns')), IncludeLaunchDescription(file)])


            def generate_launch_description():
                files = [included(ending) for ending in ('py', 'xml', 'yaml')]
                return LaunchDescription([DeclareLaunchArgument('ns', default_value='my/ns'), *files])
            """,
        'xml': '<launch>\n<arg name="ns" default="my/ns"/>\n'
        + ''.join(
            '<group><push_ros_namespace namespace="$(var ns)"/>'
            f'<include file="$(find-pkg-share probe)/inner_launch.{ending}"/></group>\n'
            for ending in inner
        )
        + '</launch>\n',
        'yaml': '%YAML 1.2\n---\nlaunch:\n- arg:\n    name: "ns"\n    default: "my/ns"\n'
        + ''.join(
            '- group:\n    - push_ros_namespace:\n        namespace: "$(var ns)"\n'
            f'    - include:\n        file: "$(find-pkg-share probe)/inner_launch.{ending}"\n'
            for ending in inner
        ),
    }
    lines = launched(kind, outer[kind])
    names = sorted(line.split()[1] for line in lines if line.startswith('name '))
    assert names == ['/my/ns/py', '/my/ns/xml', '/my/ns/yaml']
