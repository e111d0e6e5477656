"""Folders that a killed run has left are removed by the next one, and no others."""

import os
import signal
import subprocess
import sys
from pathlib import Path

from helpers import paths
from helpers.runner import scratch

HOLD = """
import sys
from helpers.runner import scratch
with scratch.folder('course-', sys.argv[1]) as path:
    print(path, flush=True)
    input()
"""


def aged(path: Path) -> Path:
    """The folder, as if nobody had written to it for two hours."""
    before = path.stat().st_mtime - 7200
    os.utime(path, (before, before))
    return path


def test_a_folder_lives_as_long_as_its_owner(tmp_path):
    with scratch.folder('course-', str(tmp_path)) as path:
        (aged(Path(path)) / 'file').write_text('x')
        aged(Path(path))
        scratch.remove_abandoned(str(tmp_path))
        assert Path(path, 'file').exists(), 'it is in use'
    assert not Path(path).exists()


def test_what_a_killed_process_leaves_is_removed_later(tmp_path):
    command = [sys.executable, '-c', HOLD, str(tmp_path)]
    with subprocess.Popen(command, cwd=paths.ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        left = Path(process.stdout.readline().strip())
        scratch.remove_abandoned(str(tmp_path))
        aged(left)
        scratch.remove_abandoned(str(tmp_path))
        assert left.is_dir(), 'its process still runs'
        process.send_signal(signal.SIGKILL)
    (left / 'ws').mkdir()
    scratch.remove_abandoned(str(tmp_path))
    assert left.is_dir(), 'somebody has just written to it'
    aged(left)
    scratch.remove_abandoned(str(tmp_path))
    assert not left.exists()


def test_folders_of_others_are_let_alone(tmp_path):
    names = ['course-kernel-abcdefgh', 'course-bench-abcdefgh', 'course-notes', 'course-12345678.txt']
    kept = [tmp_path / name for name in names]
    for path in kept:
        path.mkdir()
    (tmp_path / 'course-aaaaaaaa').symlink_to(tmp_path / 'course-notes')
    (tmp_path / 'course-bbbbbbbb').write_text('a file')
    for path in tmp_path.iterdir():
        aged(path)
    scratch.remove_abandoned(str(tmp_path))
    assert {path.name for path in tmp_path.iterdir()} == {*names, 'course-aaaaaaaa', 'course-bbbbbbbb'}
