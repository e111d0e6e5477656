"""A workspace with `launch` and `launch_ros`, or with the packages of ros2cli, takes the place of those here.

The overlays are made of these packages themselves, with another version. What upstream's own have, and other packages
here may therefore use, is a list of names.
"""

import ast
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from environment.tests.running import PATIENCE
from helpers.programs.processes import background

SOURCES = Path(__file__).parents[1] / 'ros2_ws' / 'src'
VERSION = '99.0.0'
LAUNCH = ('launch', 'launch_ros')
ROS2CLI = tuple(
    f'ros2{each}'
    for each in ('cli', 'action', 'doctor', 'interface', 'lifecycle', 'node', 'param', 'pkg', 'run', 'service', 'topic')
)
# What packages outside of the two groups import from them, all of it in upstream's packages of Jazzy, too.
UPSTREAM = {
    'launch': 'LaunchContext LaunchDescription LaunchDescriptionEntity LaunchDescriptionSource LaunchService '
    'SomeSubstitutionsType frontend',
    'launch.action': 'Action',
    'launch.actions': 'EmitEvent ExecuteProcess IncludeLaunchDescription RegisterEventHandler TimerAction',
    'launch.event_handlers': 'OnProcessExit OnProcessIO OnProcessStart',
    'launch.events': 'matches_action',
    'launch.events.process': 'ProcessExited ProcessIO ProcessStarted RunningProcessEvent ShutdownProcess',
    'launch.frontend': 'Parser',
    'launch.frontend.type_utils': 'check_is_list_entity',
    'launch.launch_context': 'LaunchContext',
    'launch.launch_description': 'LaunchDescription',
    'launch.launch_description_entity': 'LaunchDescriptionEntity',
    'launch.launch_description_sources': 'AnyLaunchDescriptionSource FrontendLaunchDescriptionSource '
    'InvalidLaunchFileError InvalidPythonLaunchFileError get_launch_description_from_any_launch_file',
    'launch.substitutions': 'FindExecutable TextSubstitution',
    'launch.utilities.type_utils': 'get_typed_value is_instance_of',
    'launch_ros.actions': 'Node',
    'launch_ros.parameter_descriptions': 'ParameterValue',
    'launch_ros.substitutions': 'FindPackageShare',
    'ros2cli.command': 'CommandExtension add_subparsers_on_demand',
}
LAUNCH_FILE = """\
<launch>
  <arg name="who" default="world"/>
  <executable cmd="echo hello $(var who)" output="screen"/>
  <node pkg="tf2_ros" exec="static_transform_publisher" name="fixed"
        args="--frame-id world --child-frame-id $(var who)"/>
</launch>
"""
LAUNCH_TEST = """\
import unittest

import launch
import launch_testing.actions
import launch_testing.markers
import pytest
from launch.actions import ExecuteProcess


@pytest.mark.launch_test
@launch_testing.markers.keep_alive  # echo may end before the test does
def generate_test_description():
    return launch.LaunchDescription([ExecuteProcess(cmd=['echo', 'heard']), launch_testing.actions.ReadyToTest()])


class TestOutput(unittest.TestCase):
    def test_it_is_heard(self, proc_output):
        proc_output.assertWaitFor('heard', stream='stdout', timeout=30)
"""


def overlay(workspace: Path, packages: tuple[str, ...]) -> None:
    """Build a workspace of these packages, in another version."""
    for package in packages:
        copy = workspace / 'src' / package
        shutil.copytree(SOURCES / package, copy, ignore=shutil.ignore_patterns('test', '__pycache__'))
        for file, line in (('package.xml', '<version>{}</version>'), ('setup.py', "version='{}'")):
            text, changed = re.subn(line.format(r'[\d.]+'), line.format(VERSION), (copy / file).read_text(), count=1)
            assert changed, file
            (copy / file).write_text(text)
    environ = {name: value for name, value in os.environ.items() if name != 'PYTHONDONTWRITEBYTECODE'}
    built = subprocess.run(
        [sys.executable, '-m', 'colcon', '--log-base', os.devnull, 'build'],
        cwd=workspace,
        env=environ,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert (built.returncode, built.stderr) == (0, ''), built


class Overlaid:
    """A terminal in which the workspace is sourced."""

    def __init__(self, workspace: Path):
        self.workspace = workspace
        self.environ = {**os.environ, 'PATH': f'{Path(sys.executable).parent}:{os.environ["PATH"]}'}

    def argv(self, command: str) -> list[str]:
        """The command, in this terminal."""
        return ['bash', '-c', f'source install/setup.bash && exec {command}']

    def output(self, command: str) -> str:
        """Run a command that must succeed, and say nothing on stderr; return what it prints."""
        done = subprocess.run(
            self.argv(command),
            cwd=self.workspace,
            env=self.environ,
            capture_output=True,
            text=True,
            timeout=2 * PATIENCE,
        )
        assert (done.returncode, done.stderr) == (0, ''), done
        return done.stdout

    def background(self, command: str):
        """Start a command; it ends with the block in which it is used."""
        return background(self.argv(command), cwd=self.workspace, env=self.environ)

    def has(self, packages: tuple[str, ...]) -> bool:
        """Return whether Python has these packages, and what is said of them, from the workspace."""
        program = (
            'import importlib, importlib.metadata\n'
            f'for name in {packages}:\n'
            '    print(importlib.metadata.version(name), importlib.import_module(name).__file__)'
        )
        lines = [line.split() for line in self.output(shlex.join(['python', '-c', program])).splitlines()]
        return all(version == VERSION and Path(file).is_relative_to(self.workspace) for version, file in lines)


@pytest.mark.one_of(10, group=4, of='builds')
@pytest.mark.early
def test_launch_and_launch_ros_from_a_workspace(domain, tmp_path):
    overlay(tmp_path, LAUNCH)
    terminal = Overlaid(tmp_path)
    assert terminal.has(LAUNCH)
    (tmp_path / 'two.launch.xml').write_text(LAUNCH_FILE)
    assert "'who':" in terminal.output('ros2 launch two.launch.xml --show-args')
    with terminal.background('ros2 launch two.launch.xml who:=ada') as launched:
        launched.wait_for_output('hello ada', PATIENCE)
        launched.wait_for_output("from 'world' to 'ada'", PATIENCE)
        assert terminal.output('ros2 node list') == '/fixed\n'
        assert launched.stop(PATIENCE) == 0
    (tmp_path / 'heard.test.py').write_text(LAUNCH_TEST)
    tested = subprocess.run(
        terminal.argv('launch_test heard.test.py'),
        cwd=tmp_path,
        env=terminal.environ,
        capture_output=True,
        text=True,
        timeout=2 * PATIENCE,
    )
    assert tested.returncode == 0, tested
    assert 'test_it_is_heard' in tested.stderr


@pytest.mark.one_of(10, group=5, of='builds')
@pytest.mark.early
def test_ros2cli_from_a_workspace(domain, tmp_path):
    some = ('ros2cli', 'ros2node', 'ros2pkg', 'ros2topic')
    overlay(tmp_path, some)
    terminal = Overlaid(tmp_path)
    assert terminal.has(some)
    with terminal.background('ros2 topic pub -r 10 /chatter std_msgs/msg/String "{data: hello}"') as publisher:
        publisher.wait_for_output('publishing #1', PATIENCE)
        assert '/chatter' in terminal.output('ros2 topic list').splitlines()
        assert terminal.output('ros2 topic echo --once /chatter') == 'data: hello\n---\n'
    assert terminal.output('ros2 pkg prefix ros2topic').strip() == str(tmp_path / 'install' / 'ros2topic')
    (tmp_path / 'one.launch.xml').write_text('<launch><log message="from a file"/></launch>')
    assert 'from a file' in terminal.output('ros2 launch one.launch.xml')
    for command in ('bag', 'launch'):  # the packages of these are others
        assert f'usage: ros2 {command}' in terminal.output(f'ros2 {command} --help')


def imported(file: Path) -> set[tuple[str, str]]:
    """(module, name) of the imports of a file."""
    return {
        (node.module, name.name)
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.ImportFrom) and node.module and not node.level
        for name in node.names
    }


@pytest.mark.parametrize('group', [LAUNCH, ROS2CLI], ids=['launch', 'ros2cli'])
def test_other_packages_need_only_what_upstreams_have(group):
    for package in sorted(SOURCES.iterdir()):
        if package.name in group:
            continue
        for file in package.rglob('*.py'):
            if {'test', 'launch'} & set(file.relative_to(package).parts[:1]):  # launch files use public names only
                continue
            for module, name in imported(file):
                if module.partition('.')[0] in group:
                    assert name in UPSTREAM.get(module, '').split(), f'{file} imports {name} from {module}'
