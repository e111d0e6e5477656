"""nbval: every chapter's solved notebook run once in a fresh kernel, one after the other, its outputs compared."""

import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from grading.authoring import execution, outputs, repeated
from helpers import paths


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield the seconds of each chapter, the kernel's start and pytest's included, and of all.

    :raises RuntimeError: a notebook does not pass.
    """
    total = 0.0
    for path in sorted((paths.ROOT / 'solutions').glob('*.ipynb')):
        seconds = _seconds(path)
        total += seconds
        yield path.stem, seconds, 's'
    yield 'all chapters', total, 's'


def _seconds(path: Path) -> float:
    (paths.ROOT / 'build').mkdir(exist_ok=True)
    # Inside of the course, so that pytest finds conftest.py for it.
    with tempfile.TemporaryDirectory(prefix='bench-', dir=paths.ROOT / 'build') as folder:
        config = Path(folder) / 'sanitize.cfg'
        config.write_text(outputs.nbval_config(paths.ROOT), encoding='utf-8')
        copy = repeated.write([path], Path(folder), runs=lambda _: ('once',))
        command = [
            sys.executable,
            '-m',
            'pytest',
            '-q',
            *repeated.nbval_arguments(config, execution.kernel_name()),
            *map(str, copy),
        ]
        begin = time.perf_counter()
        done = subprocess.run(command, cwd=paths.ROOT, capture_output=True, text=True, timeout=900)
        seconds = time.perf_counter() - begin
    if done.returncode:
        raise RuntimeError(f'{path.name} does not pass: {done.stdout[-1500:]}')
    return seconds
