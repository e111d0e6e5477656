"""The command line: time of --help, and of checking chapter 3 as it stands in notebooks/."""

import subprocess
import sys
import time
from collections.abc import Iterator

from helpers import paths


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield the best of three runs of --help and one of ``check 3``."""
    yield './course --help, best of 3', 1e3 * min(_seconds('--help') for _ in range(3)), 'ms'
    yield './course check 3', _seconds('check', '3'), 's'


def _seconds(*arguments: str) -> float:
    begin = time.perf_counter()
    command = [sys.executable, '-m', 'helpers.cli', *arguments]
    done = subprocess.run(command, cwd=paths.ROOT, capture_output=True, text=True, timeout=300)
    if done.returncode not in (0, 1):  # 1: the notebook is not solved
        raise RuntimeError(f'./course {" ".join(arguments)} ended with {done.returncode}: {done.stderr.strip()}')
    return time.perf_counter() - begin
