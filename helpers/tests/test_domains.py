"""Claimed ROS domain ids: nobody has the same one at the same time, whoever asks."""

import os
import subprocess
import sys
import tempfile
from contextlib import ExitStack

import pytest

from helpers.domains import FIRST, LAST, claim
from helpers.tests.kernels import ROOT

HOLD = 'from helpers.domains import claim\nwith claim() as number:\n    print(number, flush=True)\n    input()'


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A folder of locks of its own, that other users may enter."""
    tmp_path = tmp_path / 'domains'
    monkeypatch.setenv('COURSE_DOMAINS_DIR', str(tmp_path))
    return tmp_path


@pytest.fixture
def holder():
    """Starts processes that hold an id until their stdin closes."""
    started = []

    def start(**options):
        env = {**os.environ, 'PYTHONPATH': str(ROOT)}
        process = subprocess.Popen(
            [sys.executable, '-c', HOLD], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=env, **options
        )
        started.append(process)
        return process, int(process.stdout.readline())

    yield start
    for process in started:
        process.kill()
        process.communicate()


def test_ids_differ_and_are_given_back():
    with claim() as one, claim() as two:
        assert FIRST <= one < two <= LAST
    with claim() as again:
        assert again == one


def test_other_processes_get_other_ids_also_after_a_kill(holder):
    (process, one), (_, two) = holder(), holder()
    with claim() as three:
        assert len({one, two, three}) == 3
        process.kill()
        process.wait()
        with claim() as four:
            assert four == one


def test_all_in_use(folder):
    with ExitStack() as stack:
        ids = [stack.enter_context(claim()) for _ in range(FIRST, LAST + 1)]
        assert sorted(ids) == list(range(FIRST, LAST + 1))
        with pytest.raises(RuntimeError, match=f'all ROS domain ids 1 to 101 are in use: .*{folder}'), claim():
            pass


def test_an_id_that_is_held_is_not_claimed(tmp_path):
    code = ('from helpers.domains import claim, hold\n'
            'hold(1)\n'
            'with claim() as one, claim() as two:\n'
            '    print(one, two)\n')
    environ = {**os.environ, 'COURSE_DOMAINS_DIR': str(tmp_path)}
    done = subprocess.run([sys.executable, '-c', code], env=environ, capture_output=True, text=True)
    assert done.stdout == '2 3\n', done.stderr


def claim_in(public, monkeypatch):
    """Claim an id in a folder that other users can reach, unlike pytest's."""
    os.chmod(public, 0o755)
    monkeypatch.setenv('COURSE_DOMAINS_DIR', f'{public}/domains')
    return claim()


@pytest.mark.skipif(os.getuid() != 0, reason='only root can become another user')
def test_other_users_share_the_ids(holder, monkeypatch):
    with tempfile.TemporaryDirectory() as public, claim_in(public, monkeypatch) as mine:
        process, theirs = holder(user=65534, group=65534, extra_groups=[])
        assert theirs != mine
        with claim() as third:
            assert third not in (mine, theirs)
        process.communicate('\n')
        with claim() as again:
            assert again == theirs, "another user's file is no obstacle once it is free"


def test_ports_stay_below_those_that_linux_hands_out():
    last_port = 7400 + 250 * LAST + 10 + 2 * 50 + 1  # Fast DDS, 50 participants in the highest domain
    assert last_port < 32768
