"""Commands that need no node: interface, pkg, run."""

import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import pytest

from environment.tests.running import PATIENCE

PYTHON_PACKAGE = """\
going to create a new package
package name: py_talker_listener
destination directory: {directory}
package format: 3
version: 0.0.0
description: TODO: Package description
maintainer: ['Ada <ada@example.org>']
licenses: ['TODO: License declaration']
build type: ament_python
dependencies: ['rclpy', 'std_msgs']
creating folder ./py_talker_listener
creating ./py_talker_listener/package.xml
creating source folder
creating folder ./py_talker_listener/py_talker_listener
creating ./py_talker_listener/setup.py
creating ./py_talker_listener/setup.cfg
creating folder ./py_talker_listener/resource
creating ./py_talker_listener/resource/py_talker_listener
creating ./py_talker_listener/py_talker_listener/__init__.py
creating folder ./py_talker_listener/test
creating ./py_talker_listener/test/test_copyright.py
creating ./py_talker_listener/test/test_flake8.py
creating ./py_talker_listener/test/test_pep257.py

[WARNING]: Unknown license 'TODO: License declaration'.  This has been set in the package.xml, but no LICENSE file \
has been created.
It is recommended to use one of the ament license identifiers:
Apache-2.0
BSL-1.0
BSD-2.0
BSD-2-Clause
BSD-3-Clause
GPL-3.0-only
LGPL-3.0-only
MIT
MIT-0
"""
MAINTAINER = ('--maintainer-name', 'Ada', '--maintainer-email', 'ada@example.org')


def files(directory):
    return sorted(str(path.relative_to(directory)) for path in directory.rglob('*') if path.is_file())


def test_create_an_ament_python_package(ros2, tmp_path):
    text = ros2.output(
        'pkg', 'create', 'py_talker_listener', '--build-type', 'ament_python', *MAINTAINER,
        '--dependencies', 'rclpy', 'std_msgs', cwd=tmp_path)
    assert text == PYTHON_PACKAGE.format(directory=tmp_path)
    assert files(tmp_path / 'py_talker_listener') == [
        'package.xml', 'py_talker_listener/__init__.py', 'resource/py_talker_listener', 'setup.cfg', 'setup.py',
        'test/test_copyright.py', 'test/test_flake8.py', 'test/test_pep257.py']
    root = ElementTree.parse(tmp_path / 'py_talker_listener' / 'package.xml').getroot()
    assert [each.text for each in root.findall('depend')] == ['rclpy', 'std_msgs']
    assert root.findtext('export/build_type') == 'ament_python'
    assert root.find('maintainer').attrib == {'email': 'ada@example.org'}
    assert (tmp_path / 'py_talker_listener' / 'setup.cfg').read_text() == (
        '[develop]\nscript_dir=$base/lib/py_talker_listener\n[install]\ninstall_scripts=$base/lib/py_talker_listener\n')


def test_a_created_python_package_builds_runs_and_passes_its_tests(ros2, tmp_path):
    source = tmp_path / 'src'
    source.mkdir()
    ros2.output('pkg', 'create', 'greeter', '--build-type', 'ament_python', '--node-name', 'greet', '--license', 'MIT',
                *MAINTAINER, cwd=source)
    assert (source / 'greeter' / 'LICENSE').read_text().startswith('Copyright 20')
    subprocess.run([sys.executable, '-m', 'pytest', '-q', source / 'greeter' / 'test'], check=True, cwd=tmp_path)
    subprocess.run(
        [sys.executable, '-m', 'colcon', 'build', '--packages-select', 'greeter'], check=True, cwd=tmp_path,
        env=ros2.environ, capture_output=True)
    command = 'source install/setup.bash && ros2 run greeter greet && ros2 pkg executables greeter'
    done = subprocess.run(['bash', '-c', command], cwd=tmp_path, env=ros2.environ, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ('Hi from greeter.\ngreeter greet\n', '')


def test_create_an_ament_cmake_package(ros2, tmp_path):
    lines = ros2.lines(
        'pkg', 'create', 'a_test_package', '--package-format', '3', '--description', 'A <dummy> description',
        '--license', 'Apache-2.0', '--build-type', 'ament_cmake', '--dependencies', 'rclcpp', *MAINTAINER,
        '--node-name', 'test_node', '--library-name', 'test_library', cwd=tmp_path)
    assert lines[10:] == [
        'node_name: test_node',
        'library_name: test_library',
        'creating folder ./a_test_package',
        'creating ./a_test_package/package.xml',
        'creating source and include folder',
        'creating folder ./a_test_package/src',
        'creating folder ./a_test_package/include/a_test_package',
        'creating ./a_test_package/CMakeLists.txt',
        'creating ./a_test_package/src/test_node.cpp',
        'creating ./a_test_package/include/a_test_package/test_library.hpp',
        'creating ./a_test_package/src/test_library.cpp',
        'creating ./a_test_package/include/a_test_package/visibility_control.h',
    ]
    root = ElementTree.parse(tmp_path / 'a_test_package' / 'package.xml').getroot()
    assert root.findtext('description') == 'A <dummy> description'
    assert root.findtext('buildtool_depend') == 'ament_cmake_ros'
    lists = (tmp_path / 'a_test_package' / 'CMakeLists.txt').read_text()
    assert lists.startswith('cmake_minimum_required(VERSION 3.8)\nproject(a_test_package)\n')
    assert 'add_library(test_library src/test_library.cpp)\n' in lists
    assert lists.endswith('ament_package()\n')
    compiled = subprocess.run(
        ['c++', '-std=c++17', '-Wall', '-Werror', '-fsyntax-only', '-I', 'include', 'src/test_node.cpp'],
        cwd=tmp_path / 'a_test_package')
    assert compiled.returncode == 0
    subprocess.run(['c++', '-std=c++17', '-fsyntax-only', '-I', 'include', 'src/test_library.cpp'], check=True,
                   cwd=tmp_path / 'a_test_package')


def test_create_refuses_what_cannot_be(ros2, tmp_path):
    (tmp_path / 'there').mkdir()
    assert ros2.error('pkg', 'create', 'there', cwd=tmp_path) == (
        '\nAborted!\nThe directory already exists: ./there\nEither remove the directory or choose a different '
        'destination directory or package name')
    assert ros2.error('pkg', 'create', 'test', '--build-type', 'ament_python', cwd=tmp_path) == (
        "Aborted since 'ament_python' packages can't be named 'test'. Please choose a different package name.")
    assert "'no way' is not a valid package name" in ros2.error('pkg', 'create', 'no way', cwd=tmp_path)
    assert "invalid choice: 'make'" in ros2.error('pkg', 'create', 'x', '--build-type', 'make', status=2, cwd=tmp_path)
    assert files(tmp_path) == []
    assert ros2.lines('pkg', 'create', 'x', '--license', '?')[:2] == ['Supported licenses:', 'Apache-2.0']


def test_pkg_finds_packages(ros2):
    names = ros2.lines('pkg', 'list')
    assert names == sorted(names)
    assert {'ros2cli', 'ros2pkg', 'rclpy', 'std_msgs'} <= set(names)
    prefix = ros2.output('pkg', 'prefix', 'ros2cli').strip()
    assert ros2.output('pkg', 'prefix', 'ros2cli', '--share') == f'{prefix}/share/ros2cli\n'
    assert ElementTree.fromstring(ros2.output('pkg', 'xml', 'ros2cli')).findtext('name') == 'ros2cli'
    assert ros2.output('pkg', 'xml', 'ros2cli', '--tag', 'license') == 'Apache-2.0\n'
    assert ros2.error('pkg', 'xml', 'ros2cli', '-t', 'nothing') == 'XML tag not found'
    for verb in ('prefix', 'xml'):
        assert ros2.error('pkg', verb, 'not_a_package') == 'Package not found'
    assert ros2.error('pkg', 'executables', 'not_a_package') == "Package 'not_a_package' not found"


def test_an_unsourced_shell_finds_the_packages_too(ros2):
    environ = {name: value for name, value in ros2.environ.items() if name != 'AMENT_PREFIX_PATH'}
    quiet = type(ros2)(environ, ros2.directory)
    assert 'ros2cli' in quiet.lines('pkg', 'list')


def test_interface_show_indents_nested_fields(ros2):
    assert ros2.output('interface', 'show', 'geometry_msgs/msg/TwistStamped') == (
        '# A twist with reference coordinate frame and timestamp\n'
        '\n'
        'std_msgs/Header header\n'
        '\tbuiltin_interfaces/Time stamp\n'
        '\t\tint32 sec\n'
        '\t\tuint32 nanosec\n'
        '\tstring frame_id\n'
        'Twist twist\n'
        '\tVector3  linear\n'
        '\t\tfloat64 x\n'
        '\t\tfloat64 y\n'
        '\t\tfloat64 z\n'
        '\tVector3  angular\n'
        '\t\tfloat64 x\n'
        '\t\tfloat64 y\n'
        '\t\tfloat64 z\n')
    expected = 'bool data\n---\nbool success\nstring message\n'
    assert ros2.output('interface', 'show', 'std_srvs/srv/SetBool', '--no-comments') == expected
    assert ros2.output('interface', 'show', '-', '--no-comments', stdin='std_srvs/srv/SetBool\n') == expected
    assert '\t# ' not in ros2.output('interface', 'show', 'std_msgs/msg/Header')
    assert '\t# ' in ros2.output('interface', 'show', 'std_msgs/msg/Header', '--all-comments')


def test_interface_names_what_is_wrong(ros2):
    assert ros2.error('interface', 'show', 'std_msgs/String') == (
        "Invalid name 'std_msgs/String'. Expected three parts separated by '/'")
    assert ros2.error('interface', 'show', 'no_such/msg/String') == "Unknown package 'no_such'"
    assert ros2.error('interface', 'show', 'std_msgs/msg/Nothing').startswith('Could not find the interface ')
    assert ros2.error('interface', 'package', 'no_such') == "Unknown package 'no_such'"
    assert ros2.error('interface', 'proto', 'std_msgs/msg/Nothing') == (
        "Could not find the interface 'std_msgs/msg/Nothing'")


def test_interface_lists(ros2):
    everything = ros2.lines('interface', 'list')
    assert everything[0] == 'Messages:'
    assert everything.index('Services:') < everything.index('Actions:')
    assert '    std_msgs/msg/String' in everything
    assert ros2.lines('interface', 'list', '--only-srvs')[0] == 'Services:'
    assert ros2.lines('interface', 'package', 'std_srvs') == [
        'std_srvs/srv/Empty', 'std_srvs/srv/SetBool', 'std_srvs/srv/Trigger']
    assert ros2.lines('interface', 'package', 'std_srvs', '-m') == []
    assert 'std_srvs' in ros2.lines('interface', 'packages', '-s')
    assert 'std_srvs' not in ros2.lines('interface', 'packages', '-m')
    assert ros2.output('interface', 'proto', 'std_srvs/srv/SetBool') == '"data: false\n"\n'
    assert ros2.output('interface', 'proto', 'geometry_msgs/msg/Point', '--no-quotes') == 'x: 0.0\ny: 0.0\nz: 0.0\n\n'


@pytest.fixture
def overlay(ros2, tmp_path):
    """A prefix with the package `tools` whose programs are the given shell scripts."""
    index = tmp_path / 'share' / 'ament_index' / 'resource_index' / 'packages'
    index.mkdir(parents=True)
    (index / 'tools').touch()
    programs = tmp_path / 'lib' / 'tools'

    def make(**scripts: str):
        for name, script in scripts.items():
            path = programs / name.replace('__', '/')
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f'#!/bin/sh\n{script}\n')
            path.chmod(0o755)
        environ = {**ros2.environ, 'AMENT_PREFIX_PATH': f'{tmp_path}:{ros2.environ.get("AMENT_PREFIX_PATH", "")}'}
        return type(ros2)(environ, tmp_path)

    return make


def test_run_passes_arguments_on(overlay):
    here = overlay(args='for each; do echo "$each"; done')
    assert here.lines('run', 'tools', 'args', 'a b', '--ros-args', '-r', '__node:=x', '-p', 'n:=1', '--help') == [
        'a b', '--ros-args', '-r', '__node:=x', '-p', 'n:=1', '--help']
    assert here.lines('run', '--prefix', 'echo "before the"', 'tools', 'args', 'after') == [
        f'before the {here.directory}/lib/tools/args after']


def test_run_says_what_is_missing(overlay):
    here = overlay(a__twice='exit 0', b__twice='exit 0')
    assert here.error('run', 'not_a_package', 'x') == "Package 'not_a_package' not found"
    assert here.error('run', 'tools', 'nothing') == 'No executable found'
    multiple = here.error('run', 'tools', 'twice').splitlines()
    assert multiple[0] == 'Multiple executables found:'
    assert [line.rpartition('/lib/')[2] for line in multiple[1:]] == ['tools/a/twice', 'tools/b/twice']


def test_run_ends_with_the_status_of_the_program(overlay):
    here = overlay(three='exit 3', killed='kill -SEGV $$')
    done = here.run('run', 'tools', 'three')
    assert (done.returncode, done.stdout) == (3, '[ros2run]: Process exited with failure 3\n')
    done = here.run('run', 'tools', 'killed')
    assert (done.returncode, done.stdout) == (256 - 11, '[ros2run]: Segmentation fault\n')


def test_run_ends_its_program(overlay):
    here = overlay(wait='trap "echo interrupted; exit 0" INT; echo waiting; while true; do sleep 0.05; done')
    with here.start('run', 'tools', 'wait') as running:
        running.wait_for_output('waiting', PATIENCE)
        running.stop(PATIENCE)  # Ctrl+C: to the whole group, as a terminal does
        assert running.lines == ['waiting', 'interrupted']
        assert running.returncode == 0
