"""Claimed ROS domain ids: nobody has the same one at the same time, whoever asks."""

import os
import shutil
import socket
import subprocess
import sys
import tempfile
from contextlib import ExitStack
from pathlib import Path

import filelock
import pytest

from environment.setup import interpreter
from helpers.kernel import domains
from helpers.kernel.domains import FIRST, LAST, claim
from helpers.tests.real_kernel import ROOT

HOLD = 'from helpers.kernel.domains import claim\nwith claim() as number:\n    print(number, flush=True)\n    input()'
# Another user may be kept out of the course's folder, and of the packages in it, as in /root: the one module and
# what it imports come with the program.
ALONE = """
import os, sys
sys.path[:0] = [os.environ['MODULES']]
import domains
with domains.claim() as number:
    print(number, flush=True)
    input()
"""


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
        program = options.pop('program', [sys.executable, '-c', HOLD])
        env |= options.pop('environ', {})
        process = subprocess.Popen(
            program, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=env, **options
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
    code = (
        'from helpers.kernel import domains\n'
        'domains._spoken_in = set\n'
        'domains.hold(1)\n'
        'with domains.claim() as one, domains.claim() as two:\n'
        '    print(one, two)\n'
    )
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


@pytest.mark.skipif(not os.access('/tmp', os.W_OK), reason='nobody may write to /tmp here')
def test_folders_for_temporary_files_of_one_user_do_not_part_the_ids(tmp_path, monkeypatch, holder):
    """As pam_tmpdir gives each user one, and a queue of jobs each job."""
    monkeypatch.delenv('COURSE_DOMAINS_DIR')
    process, number = holder(environ={'TMPDIR': str(tmp_path)})
    opened = [os.readlink(path) for path in Path(f'/proc/{process.pid}/fd').iterdir()]
    assert f'/tmp/ros-domains/{number}.lock' in opened


def claim_in(public, monkeypatch):
    """Claim an id in a folder that other users can reach, unlike pytest's."""
    os.chmod(public, 0o755)
    monkeypatch.setenv('COURSE_DOMAINS_DIR', f'{public}/domains')
    return claim()


@pytest.mark.skipif(os.getuid() != 0, reason='only root can become another user')
@pytest.mark.skipif(
    not interpreter.probe(interpreter.SYSTEM),
    reason='no /usr/bin/python3, which every user can run; run: sudo apt install python3',
)
def test_other_users_share_the_ids(holder, monkeypatch):
    with tempfile.TemporaryDirectory() as public, claim_in(public, monkeypatch) as mine:
        modules = Path(public, 'modules')
        shutil.copytree(Path(filelock.__file__).parent, modules / 'filelock', ignore=shutil.ignore_patterns('*.pyc'))
        shutil.copy(domains.__file__, modules)
        program = [interpreter.SYSTEM, '-ISc', ALONE]
        process, theirs = holder(
            user=65534, group=65534, extra_groups=[], cwd='/', program=program, environ={'MODULES': str(modules)}
        )
        assert theirs != mine
        with claim() as third:
            assert third not in (mine, theirs)
        process.communicate('\n')
        assert theirs in all_but(mine), "another user's file is no obstacle once it is free"


def test_ports_stay_below_those_that_linux_hands_out():
    last_port = 7400 + 250 * LAST + 10 + 2 * 50 + 1  # Fast DDS, 50 participants in the highest domain
    assert last_port < 32768


@pytest.fixture
def copies(tmp_path):
    """Makes copies of the course: `copies('a')` returns the domain that copy a keeps."""

    def ask(name):
        root = tmp_path / name
        root.mkdir(exist_ok=True)
        return domains.of_copy(root, root / 'memory')

    return ask


def test_copies_keep_domains_of_their_own(copies, tmp_path):
    first = {name: copies(name) for name in 'abcde'}
    assert len(set(first.values())) == 5
    (tmp_path / 'a' / 'memory').unlink()  # set up anew
    assert {name: copies(name) for name in 'edcba'} == first


def test_a_copy_keeps_its_domain_where_tmp_was_emptied(copies, folder):
    first = copies('a')
    for mark in folder.glob('*.copy'):
        mark.unlink()
    assert copies('a') == first
    for mark in folder.glob('*.copy'):
        mark.write_text(str(folder))  # another one was there before
    assert copies('a') != first


def test_the_domain_of_a_copy_that_is_gone_is_free(copies, tmp_path, monkeypatch):
    monkeypatch.setattr(domains, '_spoken_in', set)
    monkeypatch.setattr(domains, 'LAST', FIRST)
    assert copies('a') == FIRST
    assert copies('b') == FIRST, 'rather the same than none'
    assert (tmp_path / 'domains' / f'{FIRST}.copy').read_text() == str(tmp_path / 'a')
    (tmp_path / 'a').rename(tmp_path / 'c')
    assert copies('b') == FIRST
    assert (tmp_path / 'domains' / f'{FIRST}.copy').read_text() == str(tmp_path / 'b')


def test_a_copy_takes_no_domain_that_is_claimed_and_claims_leave_it_alone(copies, monkeypatch):
    monkeypatch.setattr(domains, '_spoken_in', set)
    monkeypatch.setattr(domains, 'LAST', FIRST + 2)
    with claim() as one:
        kept = copies('a')
        assert kept != one
        with claim() as two:
            assert two not in (one, kept)


def test_two_terminals_of_one_copy_at_once_agree(tmp_path):
    code = (
        'import sys; from pathlib import Path; from helpers.kernel import domains; sys.stdin.read();'
        'print(domains.of_copy(Path(sys.argv[1]), Path(sys.argv[1], "memory")))'
    )
    pair = [
        subprocess.Popen(
            [sys.executable, '-c', code, str(tmp_path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            cwd=ROOT,
        )
        for _ in range(4)
    ]
    for process in pair:
        process.stdin.close()
        process.stdin = None
    assert len({process.communicate(timeout=60)[0] for process in pair}) == 1
