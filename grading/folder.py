"""The folder of a run's results: its lock, its settings, its records, its log.

The truth is `results/<learner>.json`. `run.json` holds what belongs to the folder: the seed, the chapters, and whether
the results are anonymous.
"""

import contextlib
import json
import logging
import os
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

from filelock import FileLock, Timeout

from environment.setup import whole_file
from grading import record as records
from grading.record import Record
from helpers.runner import seeds
from helpers.runner.text import MAX_OUTPUT, clean

RESULTS = 'results'


class FolderError(Exception):
    """The folder cannot be used; the message says why."""


@dataclass(frozen=True)
class _Known:
    """What holds for all runs into a folder."""

    seed: str
    anonymous: bool
    chapters: tuple[int, ...]  # none: all


class _Lines(logging.Formatter):
    """Each record begins a line and no other text does: what learners' programs say cannot look like a record."""

    def format(self, record: logging.LogRecord) -> str:
        return clean(super().format(record), MAX_OUTPUT).replace('\n', '\n    ')


class _LogFile(logging.FileHandler):
    """What cannot be written ends the run, as with any other file of the folder: a disk is full, say."""

    def handleError(self, record: logging.LogRecord) -> None:
        raise  # noqa: PLE0704 - logging calls this where it has caught the error


class Folder:
    """Where results go."""

    def __init__(self, path: Path):
        self.path = path

    @contextlib.contextmanager
    def open(self) -> Iterator[logging.Logger]:
        """Hold the folder, and give its log. Nobody else can write results here meanwhile.

        :raises FolderError: another run holds it, or it cannot be written.
        """
        try:
            self.path.mkdir(parents=True, exist_ok=True)
            lock = FileLock(self.path / '.lock', timeout=0, thread_local=False)
            lock.acquire()
        except Timeout:
            raise FolderError(
                f'another grade is writing to {self.path}{self._holder()}: wait for its end, or give another folder'
            ) from None
        except OSError as error:
            raise FolderError(f'{self.path} cannot be written: {error.strerror}') from None
        try:
            (self.path / '.lock').write_text(f'{os.getpid()}\n')
            for left in self.path.rglob(f'.*{whole_file.TEMPORARY}'):  # of a run that was killed
                left.unlink()
            log = logging.Logger('grade', logging.INFO)
            handler = _LogFile(self.path / 'run.log', encoding='utf-8')
            handler.setFormatter(_Lines('%(asctime)s %(levelname)s %(message)s'))
            log.addHandler(handler)
            try:
                yield log
            finally:
                handler.close()
        finally:
            lock.release()

    def _holder(self) -> str:
        try:
            return f' (process {int((self.path / ".lock").read_text())})'
        except (OSError, ValueError):
            return ''

    def chapters(self, wanted: Iterable[int] = ()) -> tuple[int, ...]:
        """The chapters that are graded here: `wanted`, else those of the folder's first run. None: the whole course.

        :raises FolderError: the folder holds results of other chapters; or it is damaged.
        """
        wanted, known = tuple(sorted(set(wanted))), self._known()
        if known is None or not wanted or known.chapters == wanted:
            return known.chapters if known else wanted
        had = f'chapter {" and ".join(map(str, known.chapters))}' if known.chapters else 'the whole course'
        raise FolderError(f'{self.path} holds results of {had}: leave --chapter out, or give another folder')

    def settle(self, seed: str, anonymous: bool, chapters: Iterable[int] = ()) -> str:
        """The folder's seed: `seed` if one is given, else the one that was drawn when the folder was new.

        :raises FolderError: the folder holds names and shall be anonymous, or the other way round; or other chapters;
            or it is damaged.
        """
        known = self._known()
        if known and known.anonymous != anonymous:
            raise FolderError(
                f'{self.path} was made {"with" if known.anonymous else "without"} --anonymous: '
                'do the same, or give another folder'
            )
        seed = seed or (known.seed if known else '') or seeds.fresh()
        settings = _Known(seed, anonymous, self.chapters(chapters))
        whole_file.update(
            self.path / 'run.json', json.dumps({'schema': records.SCHEMA} | asdict(settings)) + '\n', sync=True
        )
        return seed

    def _known(self) -> '_Known | None':
        """What the folder's earlier runs settled; None if there was none."""
        path = self.path / 'run.json'
        try:
            known = json.loads(path.read_text(encoding='utf-8'))
            return _Known(str(known['seed']), bool(known['anonymous']), tuple(map(int, known.get('chapters', ()))))
        except FileNotFoundError:
            return None
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise FolderError(f'{path} is damaged ({error}): give another folder, or remove that file') from None

    def records(self) -> dict[str, Record]:
        """All records that there are and can be used, by learner."""
        found = (Record.load(path) for path in sorted((self.path / RESULTS).glob('*.json')))
        return {record.learner: record for record in found if record is not None}

    def write(self, record: Record) -> None:
        """Write a record, as a whole or not at all."""
        whole_file.update(self.path / RESULTS / f'{record.learner}.json', record.dumps(), sync=True)
