"""The command line: `./course --help`, and a check of chapter 3 as it stands in notebooks/, from start to end."""

import statistics
import subprocess
import time
from collections.abc import Iterator

from grading.bench import Measurement
from helpers import paths

REPEATS = 5


def measure() -> Iterator[Measurement]:
    """Yield the median of several runs of each, after one that does not count.

    :raises RuntimeError: one ended in another way than it should.
    """
    for arguments in (('--help',), ('check', '3')):
        _seconds(*arguments)
        seconds = statistics.median(_seconds(*arguments) for _ in range(REPEATS))
        yield Measurement(f'./course {" ".join(arguments)}', seconds, 's')


def _seconds(*arguments: str) -> float:
    begin = time.perf_counter()
    command = [str(paths.ROOT / 'course'), *arguments]
    done = subprocess.run(command, cwd=paths.ROOT, capture_output=True, text=True, timeout=300)
    seconds = time.perf_counter() - begin
    if done.returncode not in (0, 1):  # 1: the notebook is not solved
        raise RuntimeError(f'./course {" ".join(arguments)} ended with {done.returncode}: {done.stderr.strip()}')
    return seconds
