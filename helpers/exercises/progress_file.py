"""What the learner's checks have found so far: one small file beside the notebooks.

`check` and `./course check` write it, the start page shows it. It is for the learner alone: no mark depends on it.
"""

import json
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path

from environment.setup import mutex, whole_file
from helpers import paths

FILE = '.progress.json'


@dataclass(frozen=True)
class Mark:
    """The latest check of an exercise."""

    points: float  # what the exercise is worth
    score: float  # what its visible tests gave
    passed: bool
    rules: int = 0  # of its card
    kept: int = 0  # rules that the visible tests have seen kept
    seed: str = ''  # of a check that did not pass: the next one shows the same values again


def load(folder: Path = paths.NOTEBOOKS) -> dict[str, Mark]:
    """Return the marks by exercise; empty if there are none, or if the file cannot be read as such."""
    try:
        rows = json.loads((folder / FILE).read_text(encoding='utf-8'))
        return {
            exercise: Mark(
                float(row['points']),
                float(row['score']),
                bool(row['passed']),
                int(row.get('rules', 0)),
                int(row.get('kept', 0)),
                str(row.get('seed', '')),
            )
            for exercise, row in rows.items()
        }
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return {}


def seeds(exercises: Iterable[str], folder: Path = paths.NOTEBOOKS) -> dict[str, str]:
    """Return the seeds of those exercises whose last check did not pass, for `helpers.runner.session.Options`."""
    marks = load(folder)
    return {exercise: marks[exercise].seed for exercise in exercises if exercise in marks and marks[exercise].seed}


def note(report, folder: Path = paths.NOTEBOOKS) -> None:
    """Keep what a check has found (`helpers.runner.session.SessionReport`).

    An exercise without a score changes nothing. Two checks at the same time lose no result: the file is replaced as a
    whole, under a lock.

    :raises OSError: the folder cannot be written to.
    """
    news = {
        result.id: Mark(
            result.points,
            result.score,
            result.passed,
            len(result.rules),
            result.count_rules('kept'),
            '' if result.passed or not result.tests else report.seeds[result.id],
        )
        for result in report.exercises
        if result.score is not None
    }
    with _alone(folder):
        marks = {**load(folder), **news}
        rows = {exercise: asdict(mark) for exercise, mark in sorted(marks.items())}
        whole_file.write(folder / FILE, json.dumps(rows, indent=1))


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Hold the file's lock. On a disk without locks nobody is kept out: a result of two checks at once may be lost."""
    from filelock import FileLock

    lock = FileLock(folder / f'{FILE}.lock', timeout=10)
    try:
        lock.acquire()
    except OSError as error:  # Timeout is one, too, without a number
        if error.errno not in mutex.NO_LOCKS:
            raise
    try:
        yield
    finally:
        lock.release()
