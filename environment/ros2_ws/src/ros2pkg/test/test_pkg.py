"""The command `ros2 pkg`."""

import subprocess
import sys
import xml.etree.ElementTree as ElementTree

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
        'pkg',
        'create',
        'py_talker_listener',
        '--build-type',
        'ament_python',
        *MAINTAINER,
        '--dependencies',
        'rclpy',
        'std_msgs',
        cwd=tmp_path,
    )
    assert text == PYTHON_PACKAGE.format(directory=tmp_path)
    assert files(tmp_path / 'py_talker_listener') == [
        'package.xml',
        'py_talker_listener/__init__.py',
        'resource/py_talker_listener',
        'setup.cfg',
        'setup.py',
        'test/test_copyright.py',
        'test/test_flake8.py',
        'test/test_pep257.py',
    ]
    root = ElementTree.parse(tmp_path / 'py_talker_listener' / 'package.xml').getroot()
    assert [each.text for each in root.findall('depend')] == ['rclpy', 'std_msgs']
    assert root.findtext('export/build_type') == 'ament_python'
    assert root.find('maintainer').attrib == {'email': 'ada@example.org'}
    assert (tmp_path / 'py_talker_listener' / 'setup.cfg').read_text() == (
        '[develop]\nscript_dir=$base/lib/py_talker_listener\n[install]\ninstall_scripts=$base/lib/py_talker_listener\n'
    )


def test_a_created_python_package_builds_runs_and_passes_its_tests(ros2, tmp_path):
    source = tmp_path / 'src'
    source.mkdir()
    ros2.output(
        'pkg',
        'create',
        'greeter',
        '--build-type',
        'ament_python',
        '--node-name',
        'greet',
        '--license',
        'MIT',
        *MAINTAINER,
        cwd=source,
    )
    assert (source / 'greeter' / 'LICENSE').read_text().startswith('Copyright 20')
    subprocess.run([sys.executable, '-m', 'pytest', '-q', source / 'greeter' / 'test'], check=True, cwd=tmp_path)
    subprocess.run(
        [sys.executable, '-m', 'colcon', 'build', '--packages-select', 'greeter'],
        check=True,
        cwd=tmp_path,
        env=ros2.environ,
        capture_output=True,
    )
    command = 'source install/setup.bash && ros2 run greeter greet && ros2 pkg executables greeter'
    done = subprocess.run(['bash', '-c', command], cwd=tmp_path, env=ros2.environ, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ('Hi from greeter.\ngreeter greet\n', '')


def test_create_an_ament_cmake_package(ros2, tmp_path):
    lines = ros2.lines(
        'pkg',
        'create',
        'a_test_package',
        '--package-format',
        '3',
        '--description',
        'A <dummy> description',
        '--license',
        'Apache-2.0',
        '--build-type',
        'ament_cmake',
        '--dependencies',
        'rclcpp',
        *MAINTAINER,
        '--node-name',
        'test_node',
        '--library-name',
        'test_library',
        cwd=tmp_path,
    )
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
        cwd=tmp_path / 'a_test_package',
    )
    assert compiled.returncode == 0
    subprocess.run(
        ['c++', '-std=c++17', '-fsyntax-only', '-I', 'include', 'src/test_library.cpp'],
        check=True,
        cwd=tmp_path / 'a_test_package',
    )


def test_create_refuses_what_cannot_be(ros2, tmp_path):
    (tmp_path / 'there').mkdir()
    assert ros2.error('pkg', 'create', 'there', cwd=tmp_path) == (
        '\nAborted!\nThe directory already exists: ./there\nEither remove the directory or choose a different '
        'destination directory or package name'
    )
    assert ros2.error('pkg', 'create', 'test', '--build-type', 'ament_python', cwd=tmp_path) == (
        "Aborted since 'ament_python' packages can't be named 'test'. Please choose a different package name."
    )
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
