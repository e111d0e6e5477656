"""A learner's workspace: what `ros2 pkg create` writes builds without a warning, and a failing test is told."""

import os
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path
from xml.etree import ElementTree

import pytest

from environment.setup import python_tests
from environment.tests.running import ROS2

MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>0.0.0</version>
  <description>made by a test</description>
  <maintainer email="ada@example.org">Ada</maintainer>
  <license>Apache-2.0</license>
  {depends}
  <export><build_type>{build_type}</build_type></export>
</package>
"""
WITHOUT = 'no line'
LINES = {
    'tests_require': "tests_require=['pytest'],",
    'tests_require_text': "tests_require='pytest',",
    'extras': "extras_require={'test': ['pytest']},",
    WITHOUT: '',
}


@pytest.fixture
def workspace(tmp_path, monkeypatch):
    """An empty workspace, in a terminal as a learner has it."""
    monkeypatch.delenv('PYTHONDONTWRITEBYTECODE', raising=False)
    monkeypatch.setenv('PATH', str(Path(sys.executable).parent), prepend=os.pathsep)
    (tmp_path / 'src').mkdir()
    return tmp_path


def colcon(workspace: Path, *words: str) -> subprocess.CompletedProcess:
    """Run colcon in the workspace."""
    return subprocess.run(
        [sys.executable, '-m', 'colcon', '--log-base', os.devnull, *words],
        cwd=workspace,
        capture_output=True,
        text=True,
        timeout=600,
    )


def python_package(workspace: Path, name: str, line: str, test: str) -> None:
    """Write a package of Python whose setup.py has the line, with the one test."""
    root = workspace / 'src' / name
    for folder in (name, 'resource', 'test'):
        (root / folder).mkdir(parents=True)
    (root / name / '__init__.py').touch()
    (root / 'resource' / name).touch()
    (root / 'package.xml').write_text(MANIFEST.format(name=name, depends='', build_type='ament_python'))
    (root / 'setup.py').write_text(
        textwrap.dedent(f"""\
        from setuptools import find_packages, setup

        setup(
            name='{name}', version='0.0.0', packages=find_packages(exclude=['test']), zip_safe=True,
            data_files=[('share/ament_index/resource_index/packages', ['resource/{name}']),
                        ('share/{name}', ['package.xml'])],
            maintainer='Ada', maintainer_email='ada@example.org', description='made by a test', license='Apache-2.0',
            {line}
        )
        """)
    )
    (root / 'test' / 'test_it.py').write_text(test)


@pytest.mark.one_of(4)
@pytest.mark.parametrize('line', LINES)
def test_a_failing_test_is_told_and_the_build_is_quiet(workspace, line):
    python_package(workspace, 'subject', LINES[line], 'def test_sum():\n    assert 1 + 1 == 3\n')
    built = colcon(workspace, 'build')
    assert (built.returncode, built.stderr) == (0, '')
    tested = colcon(workspace, 'test', '--return-code-on-test-failure')
    assert (tested.returncode, '1 package had test failures: subject' in tested.stdout) == (1, True)
    result = colcon(workspace, 'test-result', '--all')
    assert (result.returncode, '1 test, 0 errors, 1 failure' in result.stdout) == (1, True)


@pytest.mark.one_of(10, group=7, of='builds')
def test_a_passing_test_passes(workspace):
    python_package(workspace, 'subject', LINES['tests_require'], 'def test_sum():\n    assert 1 + 1 == 2\n')
    assert colcon(workspace, 'build').returncode == 0
    assert colcon(workspace, 'test', '--return-code-on-test-failure').returncode == 0
    assert 'Summary: 1 test, 0 errors, 0 failures, 0 skipped' in colcon(workspace, 'test-result').stdout


def test_which_packages_have_tests(tmp_path):
    assert not python_tests.has_tests(tmp_path)
    (tmp_path / 'test').mkdir()
    (tmp_path / 'test' / 'helper.py').touch()
    assert not python_tests.has_tests(tmp_path)
    (tmp_path / 'test' / 'one_test.py').touch()
    assert python_tests.has_tests(tmp_path)


def results(workspace: Path) -> dict[str, tuple[int, int, int]]:
    """(tests, failures and errors, skipped) of each JUnit file below build/."""
    found = {}
    for file in workspace.glob('build/*/**/*.xml'):
        suite = ElementTree.parse(file).getroot()
        if suite.tag in ('testsuite', 'testsuites'):
            one = suite if suite.tag == 'testsuite' else suite[0]
            number = [int(one.get(key) or 0) for key in ('tests', 'failures', 'errors', 'skipped')]
            found[f'{file.parent.name}/{file.name}'] = (number[0], number[1] + number[2], number[3])
    return found


@pytest.mark.one_of(10, group=0, of='builds')
@pytest.mark.early
def test_new_packages_build_and_pass_their_tests(workspace):
    def create(*words):
        subprocess.run(
            [
                ROS2,
                'pkg',
                'create',
                *words,
                '--maintainer-name',
                'Ada',
                '--maintainer-email',
                'ada@example.org',
                '--license',
                'Apache-2.0',
            ],
            cwd=workspace / 'src',
            check=True,
            capture_output=True,
        )

    create('plain', '--build-type', 'ament_cmake')
    create('native', '--build-type', 'ament_cmake', '--node-name', 'talk', '--library-name', 'words')
    create('without_ament', '--build-type', 'cmake', '--node-name', 'talk', '--library-name', 'words')
    create('python', '--build-type', 'ament_python', '--node-name', 'talk')
    built = colcon(workspace, 'build')
    assert (built.returncode, built.stderr) == (0, '')
    assert (workspace / 'install/without_ament/share/without_ament/cmake/without_amentConfig.cmake').is_file()
    tested = colcon(workspace, 'test', '--return-code-on-test-failure')
    assert tested.returncode == 0, tested.stdout
    found = results(workspace)
    assert found['plain/lint_cmake.xunit.xml'] == found['plain/xmllint.xunit.xml'] == (1, 0, 0)
    assert found['native/uncrustify.xunit.xml'] == ((4, 0, 0) if shutil.which('uncrustify') else (1, 0, 1))
    # Upstream's linter leaves out the versions of cppcheck that are slow, as are those of Debian 12 and Ubuntu 24.04.
    tests, failures, skipped = found['native/cppcheck.xunit.xml']
    assert tests and not failures and skipped in (0, tests)
    assert found['python/pytest.xml'] == (3, 0, 1)  # the copyright test, until the files have a header


@pytest.mark.one_of(10, group=1, of='builds')
def test_the_linters_of_a_new_package_find_what_is_wrong(workspace):
    subprocess.run(
        [ROS2, 'pkg', 'create', 'subject', '--build-type', 'ament_python', '--license', 'Apache-2.0'],
        cwd=workspace / 'src',
        check=True,
        capture_output=True,
    )
    (workspace / 'src/subject/subject/late.py').write_text('"""too short"""\nimport sys\n\n\ndef f( ):\n    pass\n')
    copyright_test = workspace / 'src/subject/test/test_copyright.py'
    lines = copyright_test.read_text().splitlines()
    copyright_test.write_text('\n'.join(line for line in lines if 'mark.skip' not in line) + '\n')
    assert colcon(workspace, 'build').returncode == 0
    assert '1 package had test failures' in colcon(workspace, 'test').stdout
    told = colcon(workspace, 'test-result', '--all', '--verbose').stdout
    assert '3 tests, 0 errors, 3 failures, 0 skipped' in told
    assert "F401 'sys' imported but unused" in told and 'E201' in told
    assert 'Found errors' in told and 'Found code style errors / warnings' in told  # copyright, pep257


def write_survey_msgs(root: Path) -> None:
    """Write an interface package as upstream's are: its own types in others, bounds, an action, and linter tests."""
    texts = {
        'msg/Hypothesis.msg': '# What was seen.\nstring class_id "none"\nfloat64 score\n',
        'msg/Survey.msg': 'uint8 OPEN=1\nstd_msgs/Header header\nHypothesis[] results\n'
        'geometry_msgs/PoseWithCovariance pose\nfloat64[<=3] bounded\nwstring<=5 label\n',
        'srv/Find.srv': 'Survey survey\n---\nbool found\n',
        'action/Visit.action': 'Survey[] goals\n---\nint32 NONE=0\nint32 code\n---\nbuiltin_interfaces/Duration left\n',
    }
    for name, text in texts.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    depends = '\n  '.join(
        [
            '<buildtool_depend>ament_cmake</buildtool_depend>',
            '<buildtool_depend>rosidl_default_generators</buildtool_depend>',
            *(f'<depend>{each}</depend>' for each in ('std_msgs', 'geometry_msgs', 'builtin_interfaces')),
            '<exec_depend>rosidl_default_runtime</exec_depend>',
            '<test_depend>ament_lint_auto</test_depend>',
            '<test_depend>ament_lint_common</test_depend>',
            '<member_of_group>rosidl_interface_packages</member_of_group>',
        ]
    )
    (root / 'package.xml').write_text(MANIFEST.format(name='survey_msgs', depends=depends, build_type='ament_cmake'))
    (root / 'CMakeLists.txt').write_text(
        textwrap.dedent(f"""\
        cmake_minimum_required(VERSION 3.5)
        project(survey_msgs)
        find_package(ament_cmake REQUIRED)
        find_package(rosidl_default_generators REQUIRED)
        find_package(std_msgs REQUIRED)
        find_package(geometry_msgs REQUIRED)
        find_package(builtin_interfaces REQUIRED)
        rosidl_generate_interfaces(${{PROJECT_NAME}}
          {' '.join(texts)}
          DEPENDENCIES std_msgs geometry_msgs builtin_interfaces
          ADD_LINTER_TESTS
        )
        ament_export_dependencies(rosidl_default_runtime)
        if(BUILD_TESTING)
          find_package(ament_lint_auto REQUIRED)
          ament_lint_auto_find_test_dependencies()
        endif()
        ament_package()
        """)
    )


@pytest.mark.one_of(16, group=7, of='what costs most')  # its C++ takes minutes
@pytest.mark.early
@pytest.mark.timeout(900)
def test_an_interface_package_as_upstream_writes_it_builds(workspace):
    write_survey_msgs(workspace / 'src' / 'survey_msgs')
    built = colcon(workspace, 'build')
    assert (built.returncode, built.stderr) == (0, '')
    program = (
        'from survey_msgs.msg import Survey; from rclpy.serialization import *; s = Survey(bounded=[1.0, 2.0]); '
        'print(deserialize_message(serialize_message(s), Survey).bounded.tolist())'
    )
    done = subprocess.run(
        ['bash', '-c', f'source install/setup.bash && "{sys.executable}" -c "{program}"'],
        cwd=workspace,
        capture_output=True,
        text=True,
    )
    assert (done.stdout, done.stderr) == ('[1.0, 2.0]\n', '')
    tested = colcon(
        workspace, 'test', '--return-code-on-test-failure', '--ctest-args', '-R', 'lint_cmake|xmllint|generated_py'
    )
    assert tested.returncode == 0, tested.stdout
    found = results(workspace)
    assert found['survey_msgs/pep257_rosidl_generated_py.xunit.xml'][0] > 1


LAUNCH_TEST = """\
import unittest

import launch
import launch_testing
from launch.actions import DeclareLaunchArgument, ExecuteProcess, TimerAction
from launch.substitutions import LaunchConfiguration


def generate_test_description():
    return launch.LaunchDescription([
        DeclareLaunchArgument('word', default_value='nothing'),
        ExecuteProcess(cmd=['cat'], name='stays'),
        TimerAction(period=0.1, actions=[ExecuteProcess(cmd=['echo', LaunchConfiguration('word')])]),
        launch_testing.actions.ReadyToTest(),
    ])


class TestWord(unittest.TestCase):
    def test_it_is_said(self, proc_output):
        proc_output.assertWaitFor('hello', timeout=5, stream='stdout')
"""
LAUNCH_TESTS_OF_CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(app)
find_package(ament_cmake REQUIRED)
if(BUILD_TESTING)
  find_package(ament_cmake_ros REQUIRED)
  find_package(launch_testing_ament_cmake REQUIRED)
  add_launch_test(test/word.py RUNNER "${ament_cmake_ros_DIR}/run_test_isolated.py" ARGS "word:=hello")
  add_launch_test("${CMAKE_CURRENT_SOURCE_DIR}/test/word.py" TARGET silent TIMEOUT 50)
endif()
ament_package()
"""


@pytest.mark.one_of(10, group=3, of='builds')
@pytest.mark.early
def test_launch_tests_of_a_cmake_package_are_run_and_told(workspace):
    """The CMakeLists.txt of the tutorial on integration tests, and a launch test that fails."""
    root = workspace / 'src' / 'app'
    (root / 'test').mkdir(parents=True)
    (root / 'test' / 'word.py').write_text(LAUNCH_TEST)
    (root / 'CMakeLists.txt').write_text(LAUNCH_TESTS_OF_CMAKE)
    needs = ''.join(f'<test_depend>{name}</test_depend>' for name in ('ament_cmake_ros', 'launch_testing_ament_cmake'))
    (root / 'package.xml').write_text(MANIFEST.format(name='app', depends=needs, build_type='ament_cmake'))
    assert colcon(workspace, 'build').returncode == 0
    assert colcon(workspace, 'test', '--return-code-on-test-failure').returncode == 1
    told = {name.rpartition('/')[2]: numbers for name, numbers in results(workspace).items() if 'xunit' in name}
    assert told == {'test_word.py.xunit.xml': (1, 0, 0), 'silent.xunit.xml': (1, 1, 0)}
    said = next((workspace / 'build/app/Testing/Temporary').glob('LastTest_*.log')).read_text()
    assert said.count('ament_cmake_ros/cmake/run_test_isolated.py') == 1, 'only one of them has a runner'
