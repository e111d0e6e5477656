"""A small process beside the kernel that ends the kernel's child processes after the kernel was killed.

Reads ``+PGID`` and ``-PGID`` lines from stdin. The pipe closes when the kernel ends, however it ends. The process
groups that are then still noted are asked to end, as by Ctrl+C: `ros2 launch` ends its programs, and `ros2 bag record`
closes its file. What is left after PATIENCE seconds is killed. Standard library only; started by
`helpers.programs.processes`.
"""

import os
import signal
import sys
import time
from contextlib import suppress
from pathlib import Path

PATIENCE = 5.0  # seconds
_LOOK_AGAIN = 0.05  # seconds: nobody tells of the end of somebody else's child


def main() -> None:
    groups = set()
    for line in sys.stdin:
        group = int(line[1:])
        groups.add(group) if line[0] == '+' else groups.discard(group)
    for group in groups:
        _signal(group, signal.SIGINT)
    end = time.monotonic() + PATIENCE
    while any(_signal(group, 0) for group in groups) and time.monotonic() < end:
        time.sleep(_LOOK_AGAIN)
    _kill(group for group in groups if _signal(group, 0))


def _signal(group: int, number: int) -> bool:
    """Send a signal to a process group; returns whether there is such a group. 0 only asks."""
    with suppress(ProcessLookupError, PermissionError):
        os.killpg(group, number)
        return True
    return False


def _kill(groups) -> None:
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
    from helpers import process_tree

    for group in groups:
        process_tree.kill_family(group)


if __name__ == '__main__':
    main()
