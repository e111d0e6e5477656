"""What a process has started, and its end. Standard library only, and quick: each check asks many times.

A process group is not all of it: `ros2 launch` gives each program that it starts a session of its own.
"""

import os
import signal
from contextlib import suppress
from pathlib import Path


def family(pid: int) -> list[int]:
    """A process and all that descends from it, parents before their children."""
    return [pid, *(one for child in children(pid) for one in family(child))]


def children(pid: int) -> list[int]:
    """The processes that a process has started, or taken over, and that still run or were not waited for.

    None if it has ended. Linux: /proc/PID/task/TID/children, see proc_pid_children(5).
    """
    found: list[int] = []
    with suppress(OSError):
        for thread in Path(f'/proc/{pid}/task').iterdir():
            found += map(int, (thread / 'children').read_text().split())
    return found


def kill_family(pid: int) -> None:
    """Kill a process, its process group, and all that descends from it with theirs. Never raises."""
    for one in family(pid):
        kill_group(one)
        with suppress(ProcessLookupError, PermissionError):
            os.kill(one, signal.SIGKILL)


def kill_group(pid: int) -> None:
    """Kill the process group that has this process's number, if there is one. Never raises."""
    with suppress(ProcessLookupError, PermissionError):
        os.killpg(pid, signal.SIGKILL)
