"""What the learner's checks have found so far: one small file beside the notebooks.

`check` and `./course check` write it, the start page shows it. It is the learner's own: nothing is graded from it.
"""

import json
import os
import tempfile
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

from helpers import paths

FILE = '.progress.json'


@dataclass(frozen=True)
class Mark:
    """The latest check of an exercise."""

    points: float  # what the exercise is worth
    score: float  # what its visible tests gave
    passed: bool


def load(folder: Path = paths.NOTEBOOKS) -> dict[str, Mark]:
    """Return the marks by exercise; empty if there are none, or if the file cannot be read as such."""
    try:
        rows = json.loads((folder / FILE).read_text(encoding='utf-8'))
        return {exercise: Mark(float(row['points']), float(row['score']), bool(row['passed']))
                for exercise, row in rows.items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return {}


def note(results: Iterable, folder: Path = paths.NOTEBOOKS) -> None:
    """Keep the results of a check (`helpers.runner.results.ExerciseResult`). One without a score changes nothing.

    Two checks at a time lose nothing but the order: the file is replaced as a whole, under a lock.

    :raises OSError: the folder cannot be written to.
    """
    from filelock import FileLock

    news = {result.id: Mark(result.points, result.score, result.passed) for result in results
            if result.score is not None}
    with FileLock(folder / f'{FILE}.lock', timeout=10):
        marks = {**load(folder), **news}
        with tempfile.NamedTemporaryFile('w', dir=folder, prefix=FILE, delete=False, encoding='utf-8') as file:
            json.dump({exercise: asdict(mark) for exercise, mark in sorted(marks.items())}, file, indent=1)
        os.replace(file.name, folder / FILE)
