"""The builder against colcon itself: the same files, with the same content."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from environment.setup.layout import Layout
from environment.setup.main import ROOT

PYTHON_PACKAGE = {
    'package.xml': """<package format="3"><name>talker</name><version>1.2.3</version>
        <description>A talker.</description><maintainer email="ada@example.org">Ada</maintainer>
        <license>Apache-2.0</license><exec_depend>rclpy</exec_depend>
        <export><build_type>ament_python</build_type></export></package>""",
    'setup.py': """from setuptools import setup
setup(name='talker', version='1.2.3', packages=['talker', 'talker.parts'], zip_safe=True,
      package_data={'talker': ['data.txt']}, install_requires=['setuptools'],
      data_files=[('share/ament_index/resource_index/packages', ['resource/talker']),
                  ('share/talker', ['package.xml']), ('share/talker/launch', ['launch/all.launch.py'])],
      entry_points={'console_scripts': ['talk = talker:main', 'parts = talker.parts:main']})
""",
    'setup.cfg': '[develop]\nscript_dir=$base/lib/talker\n[install]\ninstall_scripts=$base/lib/talker\n',
    'resource/talker': '',
    'launch/all.launch.py': '# a launch file\n',
    'talker/__init__.py': 'def main():\n    print("talks")\n',
    'talker/parts/__init__.py': 'from talker import main\n',
    'talker/data.txt': 'data\n',
}
INTERFACES = {
    'package.xml': """<package format="3"><name>greetings</name><version>0.1.0</version>
        <description>Words.</description><maintainer email="ada@example.org">Ada</maintainer>
        <license>Apache-2.0</license>
        <buildtool_depend>ament_cmake</buildtool_depend><buildtool_depend>rosidl_default_generators</buildtool_depend>
        <depend>turtlesim</depend><depend>std_msgs</depend><exec_depend>rosidl_default_runtime</exec_depend>
        <member_of_group>rosidl_interface_packages</member_of_group>
        <export><build_type>ament_cmake</build_type></export></package>""",
    'CMakeLists.txt': """cmake_minimum_required(VERSION 3.16)
project(greetings)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(turtlesim REQUIRED)
find_package(std_msgs REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Greeting.msg" "srv/Greet.srv" DEPENDENCIES std_msgs turtlesim)
ament_export_dependencies(rosidl_default_runtime)
ament_package()
""",
    'msg/Greeting.msg': '# A greeting\nint8 LOUD = 3\nstd_msgs/Header header\nturtlesim/Color[] colors\n'
    'string<=5 text "hi"\n',
    'srv/Greet.srv': 'greetings/Greeting greeting\nfloat64[3] place\n---\nbool heard\n',
}
pytestmark = [pytest.mark.timeout(300), pytest.mark.one_of(10, group=6, of='builds')]


@pytest.fixture(scope='module')
def workspace(tmp_path_factory):
    """The sources of two packages."""
    root = tmp_path_factory.mktemp('a workspace')
    for package, files in (('talker', PYTHON_PACKAGE), ('greetings', INTERFACES)):
        for name, text in files.items():
            path = root / 'src' / package / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    return root


def environ(**more) -> dict[str, str]:
    """What a terminal of the course has."""
    script = f'. "{sys.prefix}/setup.bash" && exec env -0'
    told = subprocess.run(['bash', '-c', script], capture_output=True, text=True, check=True).stdout
    found = dict(item.split('=', 1) for item in told.split('\0') if '=' in item)
    return {**found, 'PYTHONPATH': str(ROOT), **more}


def build(command: list[str], workspace: Path, name: str) -> Path:
    """Build into `workspace`/NAME; returns that prefix."""
    prefix = workspace / name
    command = [
        *command,
        '--log-base',
        str(workspace / f'log {name}'),
        'build',
        '--merge-install',
        '--base-paths',
        str(workspace / 'src'),
        '--build-base',
        str(workspace / f'build {name}'),
        '--install-base',
        str(prefix),
        '--cmake-args',
        '-G',
        'Ninja',
        '-DBUILD_TESTING=OFF',
        f'-DPython3_EXECUTABLE={sys.executable}',
        f'-DCMAKE_PROJECT_INCLUDE={Layout(ROOT).cmake_include}',
    ]
    done = subprocess.run(command, env=environ(), cwd=workspace, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return prefix


def files(prefix: Path, workspace: Path) -> dict[str, bytes]:
    """The installed files, and what is in those of text; the folders' own names are left out."""
    found = {}
    for parent, _, names in os.walk(prefix):
        for path in (Path(parent, name) for name in names if '__pycache__' not in parent):
            data = path.read_bytes()
            for folder in (f'build {prefix.name}', prefix.name):
                data = data.replace(os.fsencode(workspace / folder), b'THERE')
            found[str(path.relative_to(prefix))] = b'a library' if b'\0' in data else data
    return found


@pytest.fixture(scope='module')
def ours(workspace):
    """The prefix that the builder made."""
    return build([sys.executable, '-m', 'environment.builder'], workspace, 'ours')


@pytest.mark.one_of(10, group=8, of='builds')
def test_the_builder_installs_what_colcon_installs(workspace, ours):
    theirs = build([str(Path(sys.executable).with_name('colcon'))], workspace, 'theirs')
    mine, expected = files(ours, workspace), files(theirs, workspace)
    assert sorted(mine) == sorted(expected)
    # setuptools notes in SOURCES.txt what it found: which of the generated files that is depends on the moment. The
    # generators write #include lines in the order of a set. Two generators install C sources of one name below
    # include/: CMake leaves the first one there if the second is less than a second younger.
    same = [
        name
        for name in expected
        if not name.endswith('SOURCES.txt') and not (name.startswith('include/') and name.endswith('.c'))
    ]
    assert [name for name in same if sorted(mine[name].splitlines()) != sorted(expected[name].splitlines())] == []
    # Else the comparison could not fail.
    assert 'lib/talker/talk' in mine
    assert any(name.endswith('.egg-info/entry_points.txt') for name in mine)
    assert len([name for name in mine if name.endswith('.so')]) == 8


def test_what_it_made_works_on_top_of_the_environment(workspace, ours):
    code = (
        'from greetings.msg import Greeting; from greetings.srv import Greet; import importlib.metadata as m;'
        'from rclpy.serialization import serialize_message as s, deserialize_message as d;'
        'print(d(s(Greeting(text="hello")), Greeting).text, Greeting.LOUD, Greet.Request().place,'
        'm.version("talker"))'
    )
    script = f'. "{ours}/setup.bash" && ros2 run talker talk && ros2 pkg executables talker && python3 -c \'{code}\''
    done = subprocess.run(['bash', '-c', script], env=environ(), capture_output=True, text=True)
    assert done.stdout.splitlines() == ['talks', 'talker parts', 'talker talk', 'hello 3 [0. 0. 0.] 1.2.3'], done.stderr


def test_a_plain_colcon_build_stands_upon_the_courses_interfaces(workspace):
    """As a learner builds: turtlesim has no C++ here, so that what is made of its messages has none."""
    command = [str(Path(sys.executable).with_name('colcon')), 'build', '--packages-select', 'greetings']
    env = environ(PYTHONPATH='', CMAKE_GENERATOR='Ninja')  # not each machine has make
    done = subprocess.run(command, env=env, cwd=workspace, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    libraries = {path.name for path in (workspace / 'install' / 'greetings' / 'lib').glob('*.so')}
    assert 'libgreetings__rosidl_typesupport_fastrtps_c.so' in libraries


def test_a_mistake_in_a_package_is_told_as_colcon_tells_it(tmp_path):
    for name, text in PYTHON_PACKAGE.items():
        path = tmp_path / 'src' / 'talker' / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text.replace("packages=['talker',", "packages=['stalker',"))
    done = subprocess.run(
        [sys.executable, '-m', 'environment.builder', 'build', '--merge-install'],
        env=environ(),
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert done.returncode != 0
    assert "error: package directory 'stalker' does not exist" in done.stderr
    assert 'Failed   <<< talker' in done.stderr
