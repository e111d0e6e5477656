"""What a killed program leaves in shared memory goes; what belongs to others stays."""

import fcntl
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from helpers.kernel import shared_memory

OLD = time.time() - 3600


def segment(folder, name, age=OLD):
    """The two files of a program; returns them."""
    files = folder / name, folder / f'{name}_el'
    for file in files:
        file.write_bytes(b'x')
        os.utime(file, (age, age))
    return files


def test_only_what_nobody_holds_is_removed(tmp_path):
    left = segment(tmp_path, 'fastrtps_0123456789abcdef')
    held = segment(tmp_path, 'fastrtps_1123456789abcdef')
    young = segment(tmp_path, 'fastrtps_2123456789abcdef', time.time())
    other = segment(tmp_path, 'fastrtps_port7411')
    with open(held[1]) as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        assert shared_memory.tidy(tmp_path) == 1
    assert not any(file.exists() for file in left)
    assert all(file.exists() for file in (*held, *young, *other))


def test_a_folder_that_is_not_there(tmp_path):
    assert shared_memory.tidy(tmp_path / 'none') == 0


PROGRAM = 'import rclpy, sys; rclpy.init(); node = rclpy.create_node("x"); print("up", flush=True); sys.stdin.read()'


@pytest.mark.skipif(not shared_memory.FOLDER.is_dir(), reason='this machine has no /dev/shm')
def test_what_fast_dds_holds_stays_and_what_it_has_left_goes(domain, monkeypatch):
    monkeypatch.delenv('FASTDDS_BUILTIN_TRANSPORTS', raising=False)
    monkeypatch.delenv('FASTRTPS_DEFAULT_PROFILES_FILE', raising=False)
    before = set(shared_memory.FOLDER.iterdir())
    with subprocess.Popen([sys.executable, '-c', PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as program:
        program.stdout.readline()
        made = [path for path in set(shared_memory.FOLDER.iterdir()) - before if _of(path, program.pid)]
        assert made, 'Fast DDS has other files now'
        for path in made:
            os.utime(path, (OLD, OLD))
        shared_memory.tidy()
        assert all(path.exists() for path in made), 'the program runs'
        program.send_signal(signal.SIGKILL)
    shared_memory.tidy()
    assert not any(path.exists() for path in made)


def _of(path, pid):
    """Whether a process has mapped the segment, or that of the lock file."""
    return str(path).removesuffix('_el') in Path(f'/proc/{pid}/maps').read_text()
