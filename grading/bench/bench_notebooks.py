"""nbval: the solved notebooks run in fresh kernels, their outputs compared; each by itself, then all side by side."""

import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from grading.authoring import execution, repeated
from helpers import paths

WORKERS = 4  # notebooks at a time: more than processors, as a notebook often waits


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield the seconds of each chapter, the kernel's start and pytest's included, then of all, WORKERS at a time.

    :raises RuntimeError: a notebook does not pass.
    """
    chapters = sorted((paths.ROOT / 'solutions').glob('*.ipynb'))
    for path in chapters:
        yield path.stem, _seconds([path]), 's'
    yield f'all chapters, {WORKERS} at a time', _seconds(chapters, f'-n{WORKERS}'), 's'


def _seconds(notebooks: list[Path], *arguments: str) -> float:
    (paths.ROOT / 'build').mkdir(exist_ok=True)
    # Inside of the course, so that pytest finds conftest.py for it.
    with tempfile.TemporaryDirectory(prefix='bench-', dir=paths.ROOT / 'build') as folder:
        copies = repeated.write(notebooks, Path(folder), runs=lambda _: ('once',))
        command = [
            sys.executable,
            '-m',
            'pytest',
            '-q',
            *arguments,
            *repeated.nbval_arguments(execution.kernel_name()),
            *map(str, copies),
        ]
        begin = time.perf_counter()
        done = subprocess.run(command, cwd=paths.ROOT, capture_output=True, text=True, timeout=1800)
        seconds = time.perf_counter() - begin
    if done.returncode:
        raise RuntimeError(f'a notebook does not pass: {done.stdout[-1500:]}')
    return seconds
