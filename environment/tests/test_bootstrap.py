"""A fresh clone, for real: minutes of building, so it runs only with COURSE_ALL_TESTS=1."""

import shutil
import signal
import subprocess
import time

import pytest

from environment.setup import cache, mutex
from environment.setup.layout import Layout
from environment.setup.main import ROOT

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(3600)]


def start(clone, environ, *arguments):
    return subprocess.Popen(
        [clone / 'course', *arguments],
        env=environ,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        # Who runs the tests in the background may have told all that they start to ignore it.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )


def copy(target):
    """Make another copy of the course, without what it has made. The learners' edition may be in no repository."""
    if (ROOT / '.git').exists():
        subprocess.run(['git', 'clone', '-q', ROOT, target], check=True)
    else:
        shutil.copytree(ROOT, target, ignore=shutil.ignore_patterns('.venv', '.home', '__pycache__'))


def test_a_clone_is_interrupted_resumed_changed_and_moved(tmp_path, clean_environ):
    # What other copies have built is not seen, so that there is something to build; what was downloaded is.
    downloads = cache.folder(clean_environ).with_name('uv')
    environ = {'UV_CACHE_DIR': str(downloads), **clean_environ, 'XDG_CACHE_HOME': str(tmp_path / 'cache')}
    clone = tmp_path / 'Jörgs-机器人'  # rosidl_adapter, unpatched, reads the paths of interfaces as ASCII
    copy(clone)
    interesting = 'import tf2_msgs.action, example_interfaces.srv; print("works")'
    command = ('shell', '--', 'python3', '-c', interesting)

    # Interrupted in the middle of the build: what is done stays done.
    first = start(clone, environ, *command)
    for line in first.stderr:
        if line.startswith('Building'):
            break
    first.send_signal(signal.SIGINT)
    rest = first.communicate(timeout=60)[1]
    assert first.returncode == 130
    assert 'goes on from here' in rest
    with mutex.exclusive(Layout(clone).mutex, lambda process: None):
        pass  # the tools that it had started have ended, too

    # Two at once go on from there; one works, the other waits.
    pair = [start(clone, environ, *command) for _ in range(2)]
    answers = [p.communicate(timeout=3000) for p in pair]
    assert [p.returncode for p in pair] == [0, 0], answers
    assert [out for out, _ in answers] == ['works\n', 'works\n']
    said = ''.join(err for _, err in answers)
    assert 'Installing' not in said
    assert said.count('The environment is ready.') == 1
    assert said.count('waiting for it to end') == 1

    # Nothing to do: quick, in processor time, as the machine may be loaded.
    started = time.monotonic()
    again = start(clone, environ, *command)
    out, err = again.communicate(timeout=60)
    assert out == 'works\n'
    assert err == ''
    assert time.monotonic() - started < 10
    script = start(clone, environ, 'shell', '--', 'ros2', 'pkg', 'prefix', 'tf2_ros')
    assert script.communicate(timeout=60) == (f'{clone}/.venv\n', '')

    # One package changed.
    with (clone / 'environment/ros2_ws/src/tf2_msgs/msg/TFMessage.msg').open('a') as file:
        file.write('# changed\n')
    changed = start(clone, environ, *command)
    out, err = changed.communicate(timeout=3000)
    assert out == 'works\n'
    # It, and what stands upon it; nothing else.
    assert ': tf2_msgs' in err and ': tf2_ros_py' in err and 'example_interfaces' not in err

    # What it needs is told when a tool is missing, and only then.
    moved = tmp_path / 'moved'
    clone.rename(moved)
    without = start(moved, {**environ, 'CXX': '/no/compiler'}, *command)
    out, err = without.communicate(timeout=60)
    assert without.returncode == 2
    assert err.splitlines() == ['course: no C++ compiler (/no/compiler) on PATH; run: sudo apt install g++']
