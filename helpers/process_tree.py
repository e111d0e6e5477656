"""What a process has started, and its end. Standard library only, and quick: each check asks many times.

A process group is not all of it: `ros2 launch` gives each program that it starts a session of its own.
"""

import os
import signal
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

ENDED = 'Z', 'X'  # and not waited for


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


def parents(pid: int) -> dict[int, int]:
    """A process and all that descends from it and still runs: pid → pid of the parent."""
    found, waiting = {pid: 0}, [pid]
    while waiting:
        one = waiting.pop()
        for child in children(one):
            with suppress(OSError, LookupError):
                if state(f'/proc/{child}')[0] not in ENDED:
                    found[child] = one
                    waiting.append(child)
    return found


def state(process: str) -> tuple[str, int]:
    """The letter for the state of a process, and its parent; `process`: its folder in a /proc. See proc_pid_stat(5)."""
    letter, parent, *_ = Path(process, 'stat').read_text().rpartition(')')[2].split(maxsplit=2)
    return letter, int(parent)


def programs(parents: Mapping[int, int], *tasks: int) -> int:
    """How many programs run that the tasks have started: a program that only waits for one other is none.

    `ros2 run` and a shell wait for what they have started, and are one program together with it.

    :param parents: pid → pid of the parent, of all that runs.
    """
    waits = set(parents.values())
    return sum(pid not in waits and pid not in tasks for pid in parents)


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
