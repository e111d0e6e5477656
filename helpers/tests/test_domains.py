"""Claimed ROS domain ids: nobody has the same one at the same time, whoever asks."""

import os
import socket
import subprocess
import sys
import tempfile
from contextlib import ExitStack

import pytest

from helpers import domains
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


def all_but(*held):
    """Claim every id that is free; `held` are the others."""
    with ExitStack() as stack:
        return {stack.enter_context(claim()) for _ in range(FIRST, LAST + 1 - len(held))}


def test_ids_differ_and_are_given_back(monkeypatch):
    monkeypatch.setattr(domains, '_spoken_in', set)
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
        assert one in all_but(two, three)


def test_all_in_use(folder):
    with ExitStack() as stack:
        ids = [stack.enter_context(claim()) for _ in range(FIRST, LAST + 1)]
        assert sorted(ids) == list(range(FIRST, LAST + 1))
        with pytest.raises(RuntimeError, match=f'all ROS domain ids 1 to 101 are in use: .*{folder}'), claim():
            pass


def test_an_id_that_is_held_is_not_claimed(tmp_path):
    code = ('from helpers import domains\n'
            'domains._spoken_in = set\n'
            'domains.hold(1)\n'
            'with domains.claim() as one, domains.claim() as two:\n'
            '    print(one, two)\n')
    environ = {**os.environ, 'COURSE_DOMAINS_DIR': str(tmp_path)}
    done = subprocess.run([sys.executable, '-c', code], env=environ, capture_output=True, text=True)
    assert done.stdout == '2 3\n', done.stderr


def test_an_id_in_which_somebody_speaks_comes_last(monkeypatch):
    with claim() as quiet:
        pass
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(('', 7400 + 250 * quiet + 11))
        with claim() as other:
            assert other != quiet
        monkeypatch.setattr(domains, '_spoken_in', lambda: set(range(FIRST + 1, LAST + 1)))
        with claim() as one, claim() as two:
            assert (one, two) == (FIRST, FIRST + 1), 'rather such a one than none'


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
        assert theirs in all_but(mine), "another user's file is no obstacle once it is free"


def test_ports_stay_below_those_that_linux_hands_out():
    last_port = 7400 + 250 * LAST + 10 + 2 * 50 + 1  # Fast DDS, 50 participants in the highest domain
    assert last_port < 32768
