"""How many programs a process has started: those that only wait for one other are one with it."""

import os
import subprocess

import pytest

from helpers import process_tree


@pytest.mark.parametrize(
    ('parents', 'tasks', 'wanted'),
    [
        ({5: 0}, [5], 0),
        ({5: 0, 6: 5, 7: 5}, [5], 2),
        ({5: 0, 6: 5, 7: 6}, [5], 1),  # 6 waits for 7, as `ros2 run` does
        ({5: 0, 6: 5, 9: 1}, [5], 2),  # 9 belongs to nobody any more
        ({9: 1}, [], 1),
        ({}, [], 0),
    ],
)
def test_programs(parents, tasks, wanted):
    assert process_tree.programs(parents, *tasks) == wanted


def test_who_runs():
    script = 'sleep 60 & sh -c "sleep 60; true" & echo; exec sleep 60'
    process = subprocess.Popen(['sh', '-c', script], stdout=subprocess.PIPE)
    try:
        process.stdout.readline()  # all of them have begun
        assert process_tree.programs(process_tree.parents(process.pid), process.pid) == 2
    finally:
        process_tree.kill_family(process.pid)
        process.communicate()
    assert process_tree.parents(process.pid) == {process.pid: 0}


def test_who_has_ended_does_not_run():
    process = subprocess.Popen(['true'])
    os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
    assert process_tree.state(f'/proc/{process.pid}') == ('Z', os.getpid())
    assert process.pid not in process_tree.parents(os.getpid())
    assert process.wait() == 0
