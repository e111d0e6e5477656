"""Feedback: `check("3.1")` in a notebook's kernel, from the key press to the verdict, for a chapter's right answers."""

import statistics
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from helpers import paths
from helpers.exercises import definitions, manifest, notebooks, program
from helpers.tests.real_kernel import Kernel

CHAPTER = 3
REPEATS = 3


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield the time of the first check in a kernel, and the median of later ones for each exercise.

    :raises RuntimeError: a right answer does not pass.
    """
    exercises = [exercise for exercise in manifest.load().values() if exercise.chapter == CHAPTER]
    medians = []
    with tempfile.TemporaryDirectory(prefix='course-bench-') as folder, Kernel(Path(folder)) as kernel:
        _run(kernel, 'from helpers import check')
        for cell in notebooks.read(paths.ROOT / 'solutions' / exercises[0].notebook):
            identifier = program.exercise_id(cell)
            # Of the other cells only what a check looks at: their text. What they need need not be there.
            kernel.run(cell.source if identifier else '\n'.join(text for _, text in definitions.of_cell(cell)))
            if identifier is None:
                continue
            if not medians:
                yield f'check("{identifier}"), the first in a kernel', _check(kernel, identifier), 's'
            medians.append(statistics.median(_check(kernel, identifier) for _ in range(REPEATS)))
            yield f'check("{identifier}"), again', medians[-1], 's'
    yield 'any check, median', statistics.median(medians), 's'


def _run(kernel: Kernel, source: str) -> str:
    result = kernel.run(source)
    if result.error:
        raise RuntimeError(f'a cell ended with {result.error}: {result.message}')
    return result.stdout


def _check(kernel: Kernel, identifier: str) -> float:
    """Seconds of one check; whether it passes is asked afterwards, from the text that the cell shows."""
    begin = time.perf_counter()
    _run(kernel, f'with __import__("IPython").utils.capture.capture_output() as shown:\n    check("{identifier}")')
    seconds = time.perf_counter() - begin
    verdict = _run(kernel, 'print(shown.outputs[0].data["text/plain"])')
    if 'Solved: ' not in verdict:
        raise RuntimeError(f'the right answer to {identifier} does not pass: {verdict}')
    return seconds
