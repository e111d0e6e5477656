"""Tests that do not end."""

import os
import shutil
import subprocess
import sys

import pytest

from helpers import paths

# A lock of C, taken twice while Python's own is held: neither a signal nor another thread gets a turn.
STUCK = """
import ctypes

import pytest


def lock_twice():
    lock = ctypes.create_string_buffer(64)
    ctypes.PyDLL(None).pthread_mutex_lock(lock)
    ctypes.PyDLL(None).pthread_mutex_lock(lock)


@pytest.fixture
def stuck_at_the_end():
    yield
    lock_twice()


def test_stuck():
    lock_twice()


def test_next():
    pass


def test_clean_up(stuck_at_the_end):
    raise ValueError


def test_last():
    pass
"""


@pytest.mark.timeout(120)
def test_what_no_signal_ends_is_told_and_the_others_run(tmp_path):
    shutil.copy(paths.ROOT / 'conftest.py', tmp_path)
    (tmp_path / 'test_it.py').write_text(STUCK)
    workers = ['-n1', '--dist=loadscope', '--no-loadscope-reorder']  # as in ./course test
    command = [sys.executable, '-m', 'pytest', '-q', *workers, '-o', 'timeout=1', '--rootdir', str(tmp_path)]
    environment = {**os.environ, 'PYTHONPATH': str(paths.ROOT)}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=100)
    assert 'crashed while running' in done.stdout and '3 failed, 2 passed' in done.stdout, done.stdout
    assert 'in lock_twice' in done.stderr and 'in test_stuck' in done.stderr
    assert 'in stuck_at_the_end' in done.stderr
