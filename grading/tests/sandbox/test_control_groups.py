"""The kernel's bounds on memory and processes: with files in place of the kernel's, and with those where it can be.

A folder of ordinary files shows what is written; only a real group shows that it works.
"""

import os
import subprocess
import sys

import pytest

from grading.sandbox import control_groups
from helpers.runner.start_processes import Limits

LIMITS = Limits(total_memory=1000, tmp=20, home=3, shared=4, processes=50)


@pytest.fixture
def group(tmp_path):
    """What the folder of a group holds."""
    (tmp_path / 'cgroup.controllers').write_text('cpuset cpu io memory pids\n')
    (tmp_path / 'cgroup.procs').write_text(f'{os.getpid()}\n77\n')
    return tmp_path


def written(path):
    return {file.name: file.read_text() for file in path.iterdir() if file.is_file()}


def test_a_group_that_is_the_graders_own(group):
    assert control_groups.settle(group, [77])
    assert (group / 'cgroup.subtree_control').read_text() == '+memory +pids'
    assert (group / 'servers' / 'cgroup.procs').read_text() in ('77', str(os.getpid()))


def test_a_group_with_processes_of_others_is_left_alone(group):
    assert not control_groups.settle(group, [])
    assert not (group / 'servers').exists()


@pytest.mark.parametrize('controllers', ['cpu pids', ''])
def test_a_group_without_the_controllers_is_left_alone(group, controllers):
    (group / 'cgroup.controllers').write_text(controllers)
    assert not control_groups.settle(group, [77])
    assert not (group / 'servers').exists()


def test_no_group(tmp_path):
    assert not control_groups.settle(tmp_path / 'nowhere', [])
    assert control_groups.settled(None) is None
    assert control_groups.settled(tmp_path) is None


def test_what_has_been_done_is_undone(group, tmp_path_factory):
    before = tmp_path_factory.mktemp('before')
    control_groups.settle(group, [77])
    pid = (group / 'servers' / 'cgroup.procs').read_text()
    control_groups.release(group, before)
    assert (group / 'cgroup.subtree_control').read_text() == '-memory -pids'
    assert (before / 'cgroup.procs').read_text() == pid


def test_the_bounds_of_a_sandbox(group):
    control_groups.settle(group, [77])
    place = control_groups.settled(group / 'servers')
    bounds = control_groups.Bounds(place, LIMITS)
    assert bounds.path.parent == group
    assert written(bounds.path) == {
        'memory.max': '1027',
        'memory.swap.max': '0',
        'memory.oom.group': '1',
        'pids.max': str(50 + control_groups.OWN),
    }
    bounds.join()
    assert (bounds.path / 'cgroup.procs').read_text() == str(os.getpid())
    assert not bounds.exceeded()
    (bounds.path / 'memory.events').write_text('low 0\noom 1\noom_kill 2\n')
    assert bounds.exceeded()
    assert not bounds.exceeded()  # it is told once
    (bounds.path / 'memory.events').write_text('nonsense')
    assert not bounds.exceeded()


def test_two_sandboxes_have_two_groups(group):
    control_groups.settle(group, [77])
    first, second = (control_groups.Bounds(group, LIMITS) for _ in range(2))
    assert first.path != second.path


def test_without_a_place_nothing_happens(tmp_path):
    for place in (None, tmp_path / 'nowhere'):
        bounds = control_groups.Bounds(place, LIMITS)
        bounds.set(LIMITS)
        bounds.join()
        assert bounds.path is None and not bounds.exceeded()
        bounds.close()


# Prints whether a group can be had, and whether the kernel has ended a process in it that takes too much.
REAL = """
import os, signal
from grading.sandbox import control_groups
from helpers.runner.start_processes import Limits

end = control_groups.begin(os.getuid() if os.geteuid() == 0 else None)
place = control_groups.settled(control_groups.own())
if place is None:
    print('none')
else:
    bounds = control_groups.Bounds(place, Limits(total_memory=50 * 2**20, tmp=0, home=0, shared=0))
    pid = os.fork()
    if pid == 0:
        bounds.join()
        held = bytearray(b'x') * 200 * 2**20
        os._exit(0)
    print(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), bounds.path is not None, bounds.exceeded())
    bounds.close()
end()
print('left' if control_groups.own() is not None and control_groups.own().name == control_groups.SERVERS else 'undone')
"""


def test_the_kernels_own():
    done = subprocess.run([sys.executable, '-c', REAL], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    if done.stdout.startswith('none'):
        pytest.skip('no control group of version 2 can be had here')
    assert done.stdout.split('\n')[:2] == ['-9 True True', 'undone']
