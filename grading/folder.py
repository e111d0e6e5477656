"""The folder of a run's results: its lock, its settings, its records, its log.

The truth is `results/<learner>.json`. `run.json` holds what belongs to the folder: the seed, and whether the results
are anonymous.
"""

import contextlib
import json
import logging
import os
from collections.abc import Iterator
from pathlib import Path

from filelock import FileLock, Timeout

from grading import record as records
from grading.record import Record
from helpers.runner import seeds
from helpers.runner.text import MAX_OUTPUT, clean

RESULTS = 'results'


class FolderError(Exception):
    """The folder cannot be used; the message says why."""


class _Lines(logging.Formatter):
    """Each record begins a line and no other text does: what learners' programs say cannot look like a record."""

    def format(self, record: logging.LogRecord) -> str:
        return clean(super().format(record), MAX_OUTPUT).replace('\n', '\n    ')


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
            raise FolderError(f'another grade is writing to {self.path}{self._holder()}: wait for its end, or give '
                              'another folder') from None
        except OSError as error:
            raise FolderError(f'{self.path} cannot be written: {error.strerror}') from None
        try:
            (self.path / '.lock').write_text(f'{os.getpid()}\n')
            for left in self.path.rglob(f'.*{records.TEMPORARY}'):  # of a run that was killed
                left.unlink()
            log = logging.Logger('grade', logging.INFO)
            handler = logging.FileHandler(self.path / 'run.log', encoding='utf-8')
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

    def settle(self, seed: str, anonymous: bool) -> str:
        """The folder's seed: `seed` if one is given, else the one that was drawn when the folder was new.

        :raises FolderError: the folder holds names and shall be anonymous, or the other way round; or it is damaged.
        """
        path = self.path / 'run.json'
        try:
            known = json.loads(path.read_text(encoding='utf-8'))
            old = str(known['seed'])
            if bool(known['anonymous']) != anonymous:
                raise FolderError(f'{self.path} was made {"with" if known["anonymous"] else "without"} --anonymous: '
                                  'do the same, or give another folder')
        except FileNotFoundError:
            old = ''
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise FolderError(f'{path} is damaged ({error}): give another folder, or remove that file') from None
        seed = seed or old or seeds.fresh()
        records.write(path, json.dumps({'schema': records.SCHEMA, 'seed': seed, 'anonymous': anonymous}) + '\n',
                      sync=True)
        return seed

    def records(self) -> dict[str, Record]:
        """All records that there are and can be used, by learner."""
        found = (Record.load(path) for path in sorted((self.path / RESULTS).glob('*.json')))
        return {record.learner: record for record in found if record is not None}

    def write(self, record: Record) -> None:
        """Write a record, as a whole or not at all."""
        records.write(self.path / RESULTS / f'{record.learner}.json', record.dumps(), sync=True)
