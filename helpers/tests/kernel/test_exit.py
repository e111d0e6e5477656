"""The end of a process that still spins: its exit status is kept, nothing aborts, nothing hangs."""

import os
import subprocess
import sys
import time

import pytest

from helpers.tests.real_kernel import ROOT

BEGIN = """
import threading, sys, time
from helpers import ros, spinning, wait_for, spin_for, collect
from helpers.tests.sample_nodes import Talker, Listener
from rclpy.executors import MultiThreadedExecutor
ros.start()
"""
STUCK = """
inside = threading.Event()
talker = Talker()
talker.create_timer(0.01, lambda: (inside.set(), {wait}))
handle = spinning(talker{executor})
assert inside.wait(20)
"""


def run(code: str, domain: int, begin: str = BEGIN):
    env = {**os.environ, 'PYTHONPATH': str(ROOT), 'ROS_DOMAIN_ID': str(domain)}
    began = time.monotonic()
    argv = [sys.executable, '-c', begin + code]
    done = subprocess.run(argv, env=env, capture_output=True, text=True, timeout=60, check=False)
    assert 'terminate called' not in done.stderr and 'Fatal Python error' not in done.stderr
    return done.returncode, done.stderr, time.monotonic() - began


@pytest.mark.one_of(3)
@pytest.mark.parametrize(
    ('code', 'status'),
    [
        ('spinning(Talker(), Listener())', 0),
        ('spinning(Talker(), Listener(), executor=MultiThreadedExecutor)', 0),
        ('spinning(Talker()); collect("/chatter", __import__("std_msgs.msg").msg.String); sys.exit(3)', 3),
        ('talker = Talker(); spin_for(0.1, talker)', 0),
        ('handle = spinning(Talker()); handle.stop(); spinning(Talker())', 0),
        ('spinning(Talker()); ros.stop()', 0),
        ('import rclpy; spinning(Talker()); rclpy.shutdown()', 0),
        ('ros.stop(); import rclpy; rclpy.init(); spinning(Talker())', 0),
        ('with spinning(Talker()): sys.exit(4)', 4),
    ],
)
def test_exit_while_spinning(domain, code, status):
    assert run(code, domain)[:2] == (status, '')


def test_exit_by_an_exception(domain):
    status, stderr, _ = run('spinning(Talker())\nraise KeyError("mine")', domain)
    assert status == 1 and stderr.rstrip().endswith("KeyError: 'mine'")


def test_spinning_alone_cleans_up_too(domain):
    """Without helpers.ros in sight: rclpy as in the tutorials."""
    code = 'import rclpy, rclpy.node, helpers; rclpy.init(); helpers.spinning(rclpy.node.Node("plain"))'
    assert run(code, domain, begin='')[:2] == (0, '')


@pytest.mark.parametrize('executor', ['', ', executor=MultiThreadedExecutor'])
@pytest.mark.parametrize('wait', ['[time.sleep(0.01) for _ in iter(int, 1)]', 'threading.Event().wait()'])
def test_exit_with_a_callback_that_never_returns(domain, executor, wait):
    """A loop in Python is interrupted; a wait inside C is named and left behind. Neither hangs the exit."""
    status, stderr, seconds = run(STUCK.format(wait=wait, executor=executor), domain)
    assert status == 0
    assert ('cannot be interrupted' in stderr) == ('Event' in wait)
    assert seconds < 40


def test_a_forked_child_does_not_clean_up_its_parents_nodes(domain):
    code = """
talker = Talker()
handle = spinning(talker)
import os
child = os.fork()
if child == 0:
    import atexit
    atexit._run_exitfuncs()  # the interpreter goes on to unload Fast DDS, which no forked child survives
    os._exit(7)
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
count = talker.count
wait_for(lambda: talker.count > count + 2)
"""
    assert run(code, domain)[0] == 0
