"""Reads what learners hand in: a zip made by `submit`, a folder of notebooks, or one notebook.

Nothing of a submission is written to disk, and no name from it is used as a path: a zip is read member by member, into
memory, within bounds.
"""

import hashlib
import json
import re
import stat
import zipfile
import zlib
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from helpers.exercises import notebooks, program
from helpers.exercises.manifest import Exercise
from helpers.exercises.notebooks import Cell, InvalidSubmission
from helpers.submit import LEARNER

MAX_ARCHIVE = 50 * 2**20  # bytes of a zip
MAX_MEMBERS = 200
MAX_TOTAL = 60 * 2**20  # bytes of all members that are read


class Unusable(Exception):
    """A path that holds no submission; the message says what was expected."""


@dataclass
class Submission:
    """One learner's work: the notebooks' bytes by file name, or what makes it unreadable."""

    learner: str
    source: Path
    files: dict[str, bytes] = field(default_factory=dict)
    problem: str = ''  # for the learner; no exercise can be graded

    def digest(self) -> str:
        """SHA-256 of what was handed in."""
        digest = hashlib.sha256(f'{self.learner}\0{self.problem}\0'.encode())
        for name, data in sorted(self.files.items()):
            digest.update(f'{name}\0{len(data)}\0'.encode() + data)
        return digest.hexdigest()

    def cells(self, notebook: str, exercises: list[Exercise]) -> list[Cell] | None:
        """The code cells of a chapter's notebook; None if it was not handed in.

        Without a file of that name, the one that has the chapter's exercises is taken ("… (1).ipynb").

        :raises InvalidSubmission: it cannot be read, or several could be it.
        """
        if self.problem:
            raise InvalidSubmission(self.problem)
        if notebook in self.files:
            return notebooks.parse(self.files[notebook], notebook)
        wanted = {exercise.id for exercise in exercises}
        found, unread = [], []
        for name, data in sorted(self.files.items()):
            try:
                cells = notebooks.parse(data, name)
            except InvalidSubmission as error:
                unread.append(error)
                continue
            if any(program.exercise_id(cell) in wanted for cell in cells):
                found.append((name, cells))
        if len(found) > 1:
            names = ' and '.join(name for name, _ in found)
            raise InvalidSubmission(f'{names} both hold exercises of {notebook}: hand in one of them.')
        if found:
            return found[0][1]
        if unread and len(unread) == len(self.files):
            raise unread[0]
        return None


def find(paths: Iterable[Path]) -> list[Submission]:
    """Read the submissions at `paths`, sorted by learner. A folder without notebooks is a folder of submissions.

    :raises Unusable: a path does not exist or holds no submission, or two are the same learner's.
    """
    found = []
    for path in paths:
        if not path.exists():
            raise Unusable(f'{path} does not exist')
        found += _inside(path)
    by_learner: dict[str, Submission] = {}
    for submission in found:
        other = by_learner.setdefault(submission.learner, submission)
        if other is not submission:
            raise Unusable(f'{other.source} and {submission.source} are both of the learner {submission.learner}: '
                           'give one of them')
    return sorted(found, key=lambda submission: submission.learner)


def _inside(path: Path) -> list[Submission]:
    if path.is_file():
        return [read(path)]
    if any(_is_notebook(child.name) for child in path.iterdir()):
        return [read(path)]
    found = [read(child) for child in sorted(path.iterdir()) if not child.name.startswith('.')
             and (child.is_dir() and any(_is_notebook(inner.name) for inner in child.iterdir())
                  or child.is_file() and child.suffix in ('.zip', '.ipynb'))]
    if not found:
        raise Unusable(f'{path} holds no submission: expected notebooks, or zip files and folders of learners')
    return found


def read(path: Path) -> Submission:
    """Read one submission. What is wrong inside becomes its `problem`.

    :raises Unusable: the path is neither a zip, a folder nor a notebook.
    """
    submission = Submission(_id(path.name if path.is_dir() else path.stem), path)
    try:
        if path.is_dir():
            for child in sorted(path.iterdir()):
                if _is_notebook(child.name) and child.is_file() and not child.is_symlink():
                    _add(submission, child.name, child.stat().st_size, child.read_bytes)
        elif path.suffix == '.zip':
            _read_zip(path, submission)
        elif path.suffix == '.ipynb':
            _add(submission, path.name, path.stat().st_size, path.read_bytes)
        else:
            raise Unusable(f'{path} is no submission: expected a .zip, a folder of notebooks or an .ipynb')
        if not submission.files:
            raise InvalidSubmission('There is no notebook in the submission.')
    except InvalidSubmission as problem:
        submission.problem, submission.files = str(problem), {}
    except OSError as error:
        raise Unusable(f'{path} cannot be read: {error.strerror}') from None
    return submission


def _read_zip(path: Path, submission: Submission) -> None:
    if path.stat().st_size > MAX_ARCHIVE:
        raise InvalidSubmission(f'The zip is larger than {MAX_ARCHIVE // 2**20} MB.')
    try:
        with zipfile.ZipFile(path) as archive:
            members = archive.infolist()
            if len(members) > MAX_MEMBERS:
                raise InvalidSubmission(f'The zip has {len(members)} members, more than {MAX_MEMBERS}.')
            for member in members:
                name = member.filename.rpartition('/')[2]
                if member.is_dir() or name.startswith('.') or '__MACOSX' in member.filename:
                    continue
                if stat.S_ISLNK(member.external_attr >> 16):
                    raise InvalidSubmission('The zip has a symbolic link in it: hand in a file made by submit.')
                if member.flag_bits & 1:
                    raise InvalidSubmission('The zip is encrypted: hand in a file made by submit.')
                if member.filename == 'submission.json':
                    _read_label(_bounded(archive, member, 10_000), submission)
                elif _is_notebook(name):
                    _add(submission, name, member.file_size,
                         lambda member=member: _bounded(archive, member, notebooks.MAX_BYTES))
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, ValueError, RuntimeError):
        raise InvalidSubmission('The zip is damaged: make it again with submit.') from None


def _bounded(archive: zipfile.ZipFile, member: zipfile.ZipInfo, limit: int) -> bytes:
    """A member's bytes; its own word about its size is not trusted."""
    with archive.open(member) as file:
        data = file.read(limit + 1)
    if len(data) > limit:
        raise InvalidSubmission(f'A file in the zip is larger than {limit / 2**20:.2g} MB.')
    return data


def _read_label(data: bytes, submission: Submission) -> None:
    try:
        learner = json.loads(data)['learner']
    except (ValueError, KeyError, TypeError, RecursionError):
        raise InvalidSubmission('submission.json in the zip is damaged: make the zip again with submit.') from None
    if not isinstance(learner, str) or not LEARNER.fullmatch(learner):
        raise InvalidSubmission('The learner\'s id in submission.json is unusable: make the zip again with submit.')
    submission.learner = learner


def _add(submission: Submission, name: str, size: int, content) -> None:
    if name in submission.files:
        raise InvalidSubmission(f'There are two notebooks called {name}: hand in one.')
    if size > notebooks.MAX_BYTES:
        raise InvalidSubmission(f'{name} is larger than {notebooks.MAX_BYTES // 2**20} MB: clear its outputs.')
    submission.files[name] = content()
    if sum(map(len, submission.files.values())) > MAX_TOTAL:
        raise InvalidSubmission(f'The notebooks are larger than {MAX_TOTAL // 2**20} MB together.')


def _is_notebook(name: str) -> bool:
    return name.endswith('.ipynb') and not name.startswith('.')


def _id(name: str) -> str:
    """A learner's id from a file's name: also a name for the files of their results."""
    plain = re.sub(r'[^A-Za-z0-9._@-]+', '_', name.removeprefix('submission-')).lstrip('._@-')[:64]
    return plain or 'unnamed'
