"""A small process beside the kernel that ends the kernel's child processes after the kernel was killed.

Reads ``+PGID`` and ``-PGID`` lines from stdin. The pipe closes when the kernel ends, however it ends; the process
groups that are then still noted are killed. Standard library only; started by `helpers.programs.processes`.
"""

import os
import signal
import sys


def main() -> None:
    groups = set()
    for line in sys.stdin:
        group = int(line[1:])
        groups.add(group) if line[0] == '+' else groups.discard(group)
    for group in groups:
        try:
            os.killpg(group, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            pass


if __name__ == '__main__':
    main()
