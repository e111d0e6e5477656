"""The servers of tests' processes: the next check finds them prepared, and they leave nothing behind."""

import os
import signal
import socket
import subprocess
import sys
from types import SimpleNamespace

import psutil
import pytest

from helpers import paths
from helpers.runner import session, start_processes, tests_process
from helpers.tests import small

pytestmark = pytest.mark.one_of(2)


@pytest.fixture(autouse=True)
def nothing_left():
    tests_process.close()
    before = set(psutil.Process().children(recursive=True))
    yield
    tests_process.close()
    left = set(psutil.Process().children(recursive=True)) - before
    assert not psutil.wait_procs(left, timeout=5)[1]


def judge(folder, source=small.TALKER, **options):
    options = session.Options(visible=small.write_tests(folder, small.VISIBLE), **options)
    return session.run(small.cells(source), [small.exercise()], options)


def both() -> list[subprocess.Popen]:
    """The processes of the servers; they must be there."""
    assert tests_process._servers is not None
    return tests_process._servers._processes


@pytest.mark.parametrize(
    ('name', 'flag', 'own'),
    [('tmp', 0, False), ('tmp', os.ST_NOEXEC, True), ('my tmp', 0, True), ('tmp$', 0, True), ('übung', 0, True)],
)
def test_programs_are_not_put_where_none_may_run(tmp_path, monkeypatch, name, flag, own):
    """Of a package that a learner has built, each program is a script that the kernel is asked to run."""
    usual = tmp_path / name
    usual.mkdir()
    monkeypatch.setattr(start_processes, 'ROOT', tmp_path / 'course')
    monkeypatch.setattr(tests_process.tempfile, 'tempdir', str(usual))
    monkeypatch.setattr(os, 'statvfs', lambda path: SimpleNamespace(f_flag=flag))
    expected = tmp_path / 'course' / '.home' / 'tmp' if own else usual
    assert tests_process.folder_for_programs() == str(expected) and expected.is_dir()


def test_settings_of_ros_and_python_disturb_no_check(tmp_path, monkeypatch):
    """Owners of a robot have such ones in their .bashrc; with them, tests and programs would not meet, or not begin."""
    for name, value in {
        'ROS_DISCOVERY_SERVER': '127.0.0.1:11811',
        'ROS_SUPER_CLIENT': 'TRUE',
        'ROS_SECURITY_ENABLE': 'true',
        'ROS_SECURITY_STRATEGY': 'Enforce',
        'ROS_LOCALHOST_ONLY': '1',
        'FASTDDS_BUILTIN_TRANSPORTS': 'SHM',
        'PYTHONWARNINGS': 'error',
    }.items():
        monkeypatch.setenv(name, value)
    report = judge(tmp_path)
    assert report.exercises[0].passed and not report.log


def test_two_servers_are_enough_for_all_checks(tmp_path):
    tests_process.stand_by()
    first = both()
    tests_process.stand_by()
    for number in range(2):
        report = judge(tmp_path / str(number))
        assert report.exercises[0].passed and not report.log
    assert judge(tmp_path / 'few', limits=start_processes.Limits(output=5000)).exercises[0].passed
    assert both() is first and all(one.poll() is None for one in first)


@pytest.mark.parametrize('which', [0, 1])
def test_one_that_has_ended_is_replaced(tmp_path, which):
    tests_process.stand_by()
    first = both()
    first[which].kill()
    report = judge(tmp_path)
    assert report.exercises[0].passed
    assert both() is not first and all(one.returncode is not None for one in first)


def test_a_session_that_is_given_up_leaves_no_process(tmp_path):
    tests_process.stand_by()
    for_ever = f'{small.TALKER}\nwhile True:\n    pass\n'
    limits = start_processes.Limits(cpu=1)
    assert not judge(tmp_path, for_ever, limits=limits).exercises[0].passed
    left = [child for one in both() for child in psutil.Process(one.pid).children(recursive=True)]
    assert not psutil.wait_procs(left, timeout=5)[1]


def test_the_environment_is_that_of_the_moment(tmp_path, monkeypatch):
    tests_process.stand_by()
    monkeypatch.setenv('SAID_LATER', 'after the server has started')
    visible = small.write_tests(tmp_path, small.VISIBLE)
    test = next(visible.rglob('test_*.py'))
    test.write_text(test.read_text() + '\nimport os\nassert os.environ["SAID_LATER"]\n')
    options = session.Options(visible=visible)
    report = session.run(small.cells(small.TALKER), [small.exercise()], options)
    assert report.exercises[0].passed and not report.log


def test_close_is_idempotent():
    tests_process.close()
    tests_process.stand_by()
    tests_process.close()
    tests_process.close()
    assert tests_process._servers is None


OWNER = """
import os, sys
from helpers.runner import tests_process
tests_process.stand_by()
print(*[process.pid for process in tests_process._servers._processes], flush=True)
sys.stdin.read()
"""


def test_they_end_with_a_killed_owner():
    command = [sys.executable, '-c', OWNER]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as owner:
        assert owner.stdout is not None  # it is a pipe
        found = [psutil.Process(int(pid)) for pid in owner.stdout.readline().split()]
        os.kill(owner.pid, signal.SIGKILL)
        assert len(found) == 2 and not psutil.wait_procs(found, timeout=30)[1]


def test_a_ros_that_cannot_be_loaded_is_told_in_one_line(tmp_path):
    """A folder of PYTHONPATH, say, hides a module that rclpy needs."""
    (tmp_path / 'yaml.py').write_text('raise ImportError("not the right yaml")')
    environment = os.environ | {'PYTHONPATH': os.pathsep.join([str(tmp_path), str(paths.ROOT)])}
    ours, theirs = socket.socketpair()
    with ours, theirs:
        command = [sys.executable, '-m', 'helpers.runner.warm', 'helpers.runner.plain_tests', str(theirs.fileno())]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, pass_fds=[theirs.fileno()])
    assert done.returncode == 1
    assert done.stderr == (
        'course: ROS cannot be loaded: not the right yaml. To see why, run in the terminal: ./course doctor\n'
    )
