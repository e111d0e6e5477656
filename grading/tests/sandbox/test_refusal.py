"""Without the sandbox grade refuses; root gives up being root; who asks for no sandbox is told what that means."""

import json
import os
import platform
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from grading import grading_run, sandbox
from grading.sandbox import mounts, probe, seccomp, unprivileged
from grading.sandbox.holder import Holder, SandboxError
from grading.submission import Submission
from helpers import paths
from helpers.tests import small

WORK = small.notebook(small.IMPORTS, f'# Exercise 90.1: a talker\n{small.STUB}')  # untouched: nothing runs


@pytest.fixture
def bin_folder(monkeypatch):
    """A PATH on which is nothing but what a test puts there, for every user."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        monkeypatch.setenv('PATH', folder)
        yield Path(folder)


def test_grade_refuses_without_bubblewrap(tmp_path, bin_folder):
    (tmp_path / 'ada.ipynb').write_bytes(WORK)
    done = subprocess.run(
        [sys.executable, '-m', 'helpers.cli', 'grade', str(tmp_path / 'ada.ipynb'), '-o', str(tmp_path / 'out')],
        cwd=paths.ROOT,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 2 and not (tmp_path / 'out').exists()
    assert 'apt-get install bubblewrap' in done.stderr and '--sandbox none' in done.stderr


def test_a_bubblewrap_that_fails_is_found_by_running_it(bin_folder):
    program = bin_folder / 'bwrap'
    program.write_text('#!/bin/sh\necho "bwrap: setting up uid map: Permission denied" >&2\nexit 1\n')
    program.chmod(0o755)
    with pytest.raises(SandboxError, match='setting up uid map'):
        Holder(mounts.tests([]))
    found = probe.problem()
    assert 'the sandbox does not work: bwrap: setting up uid map: Permission denied; ' in found and len(found) > 90


def test_no_sandbox_is_said_and_recorded(tmp_path):
    course = grading_run.Course((small.exercise(),), tmp_path / 'checks', tmp_path / 'hidden', 'none')
    grading_run.grade([Submission('ada', tmp_path / 'ada.ipynb', {small.NOTEBOOK: WORK})], course, tmp_path / 'out')
    assert json.loads((tmp_path / 'out' / 'results' / 'ada.json').read_text())['sandbox'] == 'none'
    assert sandbox.WARNING in (tmp_path / 'out' / 'run.log').read_text()


@pytest.mark.skipif(os.geteuid() != 0, reason='only root has something to give up')
def test_root_becomes_an_ordinary_user_who_sees_only_what_is_needed(tmp_path):
    private = tmp_path / 'private'
    (private / 'course').mkdir(parents=True)
    (private / 'course' / 'file').write_text('needed')
    (private / 'secret').write_text('secret')
    private.chmod(0o700)
    closed = tmp_path / 'closed'  # as mktemp -d makes it
    (closed / 'part').mkdir(parents=True)
    closed.chmod(0o700)
    script = f'id -u; id -G; cat {private}/course/file; ls {private} {closed}; echo x > {private}/course/file'
    done = subprocess.run(
        unprivileged.command(['/bin/sh', '-c', script], [paths.ROOT, private / 'course', closed]),
        cwd='/',
        capture_output=True,
        text=True,
        env={**os.environ, 'PYTHONPATH': str(paths.ROOT)},
    )
    user, groups, *lines = done.stdout.split('\n')
    assert int(user) == unprivileged.account().pw_uid != 0 and '0' not in groups.split()
    assert lines[0].startswith('needed') and 'secret' not in done.stdout and 'part' in done.stdout
    assert 'ermission denied' in done.stderr and (private / 'course' / 'file').read_text() == 'needed'
    assert not os.path.ismount(private)  # on the machine nothing has changed


def test_an_ordinary_user_needs_no_change(monkeypatch):
    monkeypatch.setattr(os, 'geteuid', lambda: 1000)
    assert unprivileged.command(['true'], []) == ['true']


def test_another_processor_has_no_filter(monkeypatch):
    monkeypatch.setattr(platform, 'machine', lambda: 'aarch64')
    with pytest.raises(OSError, match='aarch64'):
        seccomp.install()


def test_the_filter_is_well_formed():
    """Its jumps stay inside, and it is short enough for the kernel."""
    text = seccomp.program()
    lines = [text[k : k + 8] for k in range(0, len(text), 8)]
    assert len(text) % 8 == 0 and len(lines) < 4096
    for number, line in enumerate(lines):
        if line[0] & 7 == 5:  # a jump
            assert number + 1 + max(line[2], line[3]) < len(lines)
    assert lines[-1] == bytes.fromhex('06000000 0000ff7f'.replace(' ', ''))
