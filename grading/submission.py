"""What one learner hands in: a zip made by `submit`, a folder of notebooks, or one notebook.

A zip may also hold packages that are answers (`helpers.exercises.package_answers`).

`grading.submissions` finds them. What looks into them runs in a child process with bounds: see `grading.reader`.

Nothing of a submission is written to disk, and no name from it is used as a path: a zip is read member by member, into
memory, within bounds.
"""

import hashlib
import io
import json
import lzma
import re
import stat
import zipfile
import zlib
from collections.abc import Iterable
from dataclasses import dataclass, field
from datetime import datetime, timezone
from pathlib import Path
from typing import NamedTuple
from unicodedata import normalize

from grading import reader
from grading.late import is_stamp, stamp
from grading.record import Attempt
from helpers.exercises import notebooks, package_answers, program
from helpers.exercises.handing_in import LEARNER
from helpers.exercises.manifest import Exercise
from helpers.exercises.migration_files import BACKUP
from helpers.exercises.notebooks import InvalidSubmission, NotebookCell
from helpers.runner import results, verdicts

MAX_ARCHIVE = 50 * 2**20  # bytes of a zip
MAX_MEMBERS = 200  # of a zip that are read
MAX_NAMES = 10_000  # of a zip: who packs a whole folder packs the products of builds, too
MAX_TOTAL = 60 * 2**20  # bytes of all members that are read
_COPY = re.compile(
    r'(( ?\(\d+\)| - Copy| copy( \d+)?)+)$'
)  # what browsers and desktops add to the name of a second file


_DAMAGED = 'The zip is damaged: make it again with submit.'
_LATEST = 253402300799  # the end of the year 9999, in seconds since 1970


class Unusable(Exception):
    """A path that holds no submission; the message says what was expected."""


class SubmittedPrograms(NamedTuple):
    """What a submission holds for some exercises, by the exercise's id."""

    programs: dict[str, dict]  # what the learner's process loads, see `helpers.exercises.program`
    without: dict[str, tuple[str, str]]  # why there is none: a verdict, and a message for the learner


@dataclass
class Submission:
    """One learner's work, or what makes it unreadable.

    `files`: the notebooks' bytes by file name, and those of packages, see `helpers.exercises.package_answers.place`.
    `unusable`: for notebooks, and for folders of packages, why they cannot be used.
    """

    learner: str
    source: Path
    files: dict[str, bytes] = field(default_factory=dict)
    problem: str = ''  # for the learner; no exercise can be graded
    unusable: dict[str, str] = field(default_factory=dict)  # for the learner; other exercises can be graded
    handed_in: str = ''  # ISO 8601, UTC
    label: str = ''  # the learner's id that a zip's submission.json says
    platform: bool = False  # whether `learner` comes from a learning platform
    notes: list[str] = field(default_factory=list)  # for the instructor
    earlier: list[Attempt] = field(default_factory=list)  # the learner's other submissions that were found
    own: str = ''  # the name that file or folder has, without what copies add to it; not made fit to be an id

    def digest(self) -> str:
        """SHA-256 of what was handed in."""
        digest = hashlib.sha256(f'{self.learner}\0{self.problem}\0'.encode(errors='backslashreplace'))
        for name, data in sorted(self.files.items()):
            digest.update(f'{name}\0{len(data)}\0'.encode(errors='backslashreplace') + data)  # not all names are text
        for name, why in sorted(self.unusable.items()):
            digest.update(f'{name}\0{why}\0'.encode(errors='backslashreplace'))
        return digest.hexdigest()

    def programs(self, exercises: Iterable[Exercise], course: Iterable[Exercise]) -> SubmittedPrograms:
        """The programs for some exercises of the course. Read in a child process."""
        exercises = list(exercises)
        if self.problem:
            return SubmittedPrograms(
                {}, dict.fromkeys((one.id for one in exercises), (verdicts.INVALID_SUBMISSION, self.problem))
            )
        found: dict[str, dict] = {}
        without: dict[str, tuple[str, str]] = {}
        for notebook in dict.fromkeys(exercise.notebook for exercise in exercises):
            mine = [exercise for exercise in exercises if exercise.notebook == notebook]
            known = [exercise for exercise in course if exercise.notebook == notebook]
            try:
                value, _ = reader.ask('grading.submission:programs', self.files, self.unusable, notebook, mine, known)
                found |= value['programs']
                without |= {identity: tuple(why) for identity, why in value['without'].items()}
            except reader.TooMuch as problem:
                without |= dict.fromkeys(
                    (one.id for one in mine), (verdicts.INVALID_SUBMISSION, f'{notebook}: {problem}')
                )
        return SubmittedPrograms(found, without)


# In a child process


def programs(
    files: dict[str, bytes], unusable: dict[str, str], notebook: str, exercises: list[Exercise], known: list[Exercise]
):
    """What `Submission.programs` says of one notebook; as JSON values."""
    without = results.NOT_ATTEMPTED, f'{notebook} was not handed in.'
    found: dict[str, dict] = {}
    whys: dict[str, tuple[str, str]] = {}
    try:
        cells = cells_of(files, unusable, notebook, known)
    except InvalidSubmission as problem:
        cells, without = None, (verdicts.INVALID_SUBMISSION, str(problem))
    for exercise in exercises:
        if cells is None and not package_answers.handed_in(exercise, files, unusable):
            whys[exercise.id] = without
            continue
        try:
            if exercise.folder:
                found[exercise.id] = package_answers.of_submission(exercise, files, unusable).as_dict()
            else:
                found[exercise.id] = program.build(cells or [], exercise).as_dict()
        except program.NotAttempted as reason:
            whys[exercise.id] = results.NOT_ATTEMPTED, str(reason)
        except program.InvalidExercise as reason:
            whys[exercise.id] = verdicts.INVALID_SUBMISSION, str(reason)
    return {'programs': found, 'without': whys}, ()


def cells_of(
    files: dict[str, bytes], unusable: dict[str, str], notebook: str, exercises: list[Exercise]
) -> list[NotebookCell] | None:
    """The code cells of a chapter's notebook; None if it was not handed in.

    Without a file of that name, the one that has the chapter's exercises is taken ("… (1).ipynb").

    :raises InvalidSubmission: it cannot be read, or several could be it.
    """
    if notebook in unusable:
        raise InvalidSubmission(unusable[notebook])
    if notebook in files:
        return notebooks.parse(files[notebook], notebook)
    files = {name: data for name, data in files.items() if is_notebook(name)}
    wanted = {exercise.id for exercise in exercises}
    found, unread = [], []
    for name, data in sorted(files.items()):
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
    if unread and len(unread) == len(files):
        raise unread[0]
    for name, why in unusable.items():
        if is_notebook(name) and (name.startswith(notebook[:3]) or not re.match(r'\d\d_', name)):
            raise InvalidSubmission(why)
    return None


def read_data(path: Path):
    """What `read` says, as a JSON value, and the bytes of the notebooks."""
    try:
        found = _read(path)
    except Unusable as problem:
        return {'no_submission': str(problem)}, ()
    return {
        'problem': found.problem,
        'handed_in': found.handed_in,
        'label': found.label,
        'notes': found.notes,
        'unusable': found.unusable,
        'files': list(found.files),
    }, found.files.values()


# In the grader's process


def read(path: Path) -> Submission:
    """Read one submission, as its file or folder is called. What is wrong inside becomes its `problem`.

    The time of handing in is what the zip says in submission.json, else that of its newest member, else that of the
    file or of the folder's newest notebook. Whoever made the file can set all of these.

    :raises Unusable: the path is neither a zip, a folder nor a notebook.
    """
    submission = Submission(identity(path.name if path.is_dir() else path.stem), path, own=own_name(path))
    try:
        value, blobs = reader.ask('grading.submission:read_data', path)
    except reader.TooMuch as problem:
        submission.problem, submission.handed_in = str(problem), changed(path)
        return submission
    if 'no_submission' in value:
        raise Unusable(value['no_submission'])
    submission.files = dict(zip(value.pop('files'), blobs, strict=True))
    for name, said in value.items():
        setattr(submission, name, said)
    return submission


def _read(path: Path) -> Submission:
    """Read one submission, in the child."""
    submission = Submission('', path)
    try:
        submission.handed_in = _time(path.stat().st_mtime)
        if not path.is_dir() and not path.is_file():
            raise Unusable(f'{path} is neither a file nor a folder')
        if path.is_dir():
            own = [
                child
                for child in sorted(path.iterdir())
                if is_notebook(child.name) and child.is_file() and not child.is_symlink()
            ]
            if own:
                submission.handed_in = _time(max(child.stat().st_mtime for child in own))
            for child in own:
                _add(submission, child.name, child.stat().st_size, child.read_bytes)
        elif path.suffix.lower() == '.zip':
            _read_zip(path, submission)
        elif path.suffix.lower() == '.ipynb':
            _add(submission, path.name, path.stat().st_size, path.read_bytes)
        else:
            raise Unusable(f'{path} is no submission: expected a .zip, a folder of notebooks or an .ipynb')
        if not any(map(is_notebook, (*submission.files, *submission.unusable))):
            raise InvalidSubmission('There is no notebook in the submission.')
    except InvalidSubmission as problem:
        submission.problem, submission.files, submission.unusable = str(problem), {}, {}
    except OSError as error:
        raise Unusable(f'{path} cannot be read: {error.strerror}') from None
    return submission


def _read_zip(file: Path | io.BytesIO, submission: Submission, outer: bool = True) -> None:
    """:param outer: whether this is what was handed in, not a zip in it."""
    if isinstance(file, Path) and file.stat().st_size > MAX_ARCHIVE:
        raise InvalidSubmission(f'The zip is larger than {MAX_ARCHIVE // 2**20} MB.')
    try:
        with zipfile.ZipFile(file) as archive:
            members = archive.infolist()
            submission.handed_in = _newest(members) or submission.handed_in
            if len(members) > MAX_NAMES:
                raise InvalidSubmission(f'The zip has {len(members)} members, more than {MAX_NAMES}.')
            for member in members:
                member.filename = member.filename.replace('\\', '/')  # as some programs on Windows pack it again
            work = [member for member in members if _is_work(member)]
            if len(work) > MAX_MEMBERS:
                raise InvalidSubmission(
                    f'The zip has {len(work)} notebooks and files of packages, more than {MAX_MEMBERS}.'
                )
            for member in work:
                _read_member(archive, member, submission)
            inner = [one for one in members if one.filename.lower().endswith('.zip') and not _aside(one.filename)]
            nothing_here = not (submission.files or submission.unusable)
            if outer and len(inner) == 1 and nothing_here:  # somebody has packed the zip once more
                _read_zip(io.BytesIO(_bounded(archive, inner[0], MAX_ARCHIVE)), submission, outer=False)
    except OSError as error:
        if error.errno is None:  # a codec's own
            raise InvalidSubmission(_DAMAGED) from None
        raise
    except (zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, NotImplementedError, ValueError, RuntimeError):
        raise InvalidSubmission(_DAMAGED) from None


def _read_member(archive: zipfile.ZipFile, member: zipfile.ZipInfo, submission: Submission) -> None:
    if stat.S_ISLNK(member.external_attr >> 16):
        raise InvalidSubmission('The zip has a symbolic link in it: hand in a file made by submit.')
    if member.flag_bits & 1:
        raise InvalidSubmission('The zip is encrypted: hand in a file made by submit.')
    if member.filename == 'submission.json':
        _read_label(_bounded(archive, member, 10_000), submission)
    elif place := package_answers.place(member.filename):
        _add_file(submission, *place, archive, member)
    else:
        name = member.filename.rpartition('/')[2]
        _add(submission, name, member.file_size, lambda: _bounded(archive, member, notebooks.MAX_BYTES))


def _is_work(member: zipfile.ZipInfo) -> bool:
    """Whether a member of a zip is read. Nothing is asked of the others: they may be links, or of any number."""
    name = member.filename
    return not (member.is_dir() or _aside(name)) and (
        name == 'submission.json' or is_notebook(name.rpartition('/')[2]) or package_answers.place(name) is not None
    )


def _aside(name: str) -> bool:
    """Whether a member of a zip is what programs have put aside: hidden files and folders, and `migrate`'s backups."""
    *folders, last = name.split('/')
    return last.startswith('.') or any(
        (folder.startswith('.') and folder.strip('.')) or folder == '__MACOSX' or folder.startswith(BACKUP)
        for folder in folders
    )


def _bounded(archive: zipfile.ZipFile, member: zipfile.ZipInfo, limit: int) -> bytes:
    """A member's bytes; its own word about its size is not trusted."""
    with archive.open(member) as file:
        data = file.read(limit + 1)
    if len(data) > limit:
        raise InvalidSubmission(f'A file in the zip is larger than {limit / 2**20:.2g} MB.')
    return data


def _read_label(data: bytes, submission: Submission) -> None:
    try:
        label = json.loads(data)
        learner, saved = label['learner'], label.get('saved')
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise InvalidSubmission('submission.json in the zip is damaged: make the zip again with submit.') from None
    if not isinstance(learner, str) or not LEARNER.fullmatch(learner):
        raise InvalidSubmission("The learner's id in submission.json is unusable: make the zip again with submit.")
    submission.label = learner
    if isinstance(saved, str) and is_stamp(saved):
        submission.handed_in = saved
    elif saved is not None:
        submission.notes.append(f'submission.json says that it was saved at {str(saved)[:40]!r}, which is no time')


def _add(submission: Submission, name: str, size: int, content) -> None:
    """Take a notebook. What is wrong with its file concerns its own exercises only."""
    files, unusable = submission.files, submission.unusable
    if size > notebooks.MAX_BYTES:
        unusable[name] = f'{name} is larger than {notebooks.MAX_BYTES // 2**20} MB: clear its outputs.'
    elif files.setdefault(name, data := content()) != data:
        unusable[name] = f'There are two notebooks called {name}: hand in one.'
    if sum(map(len, files.values())) > MAX_TOTAL:
        raise InvalidSubmission(f'The notebooks are larger than {MAX_TOTAL // 2**20} MB together.')


def _add_file(
    submission: Submission, folder: str, name: str, archive: zipfile.ZipFile, member: zipfile.ZipInfo
) -> None:
    """Take a file of a package. What is wrong with a package concerns its own exercise only."""
    files, key = submission.files, f'{folder}/{name}'
    if folder in submission.unusable:
        return
    mine = [other for other in files if other.startswith(f'{folder}/')]
    size = sum(len(files[other]) for other in mine)
    if key in files:
        submission.unusable[folder] = f'There are two files called {key} in the zip: make it again with submit.'
    elif len(mine) <= package_answers.MAX_FILES and size <= package_answers.MAX_BYTES:  # else they are too many
        with archive.open(member) as file:
            files[key] = file.read(package_answers.MAX_FILE + 1)


def is_notebook(name: str) -> bool:
    """Whether a file of this name is read as a notebook: a package's files stand in a folder."""
    return name.lower().endswith('.ipynb') and not name.startswith('.') and '/' not in name


def own_name(path: Path) -> str:
    """The name of a file or folder, without what `submit`, browsers and desktops add to a learner's."""
    name = written(path.name if path.is_dir() else path.stem)
    return _COPY.sub('', name.removeprefix('submission-'))


def written(name: str) -> str:
    """A file's name as a text that any file can hold: what is no UTF-8 in it stands there as its code."""
    return normalize('NFC', name.encode('utf-8', 'backslashreplace').decode())


def apart(own: str) -> str:
    """An id for a name whose plain id is another learner's: so long that nobody finds a name which gives it, too."""
    digest = hashlib.sha256(own.encode()).hexdigest()[:20]
    return f'{identity(own)[:43]}-{digest}'


def is_apart(learner: str) -> bool:
    """Whether an id has the form of those that `apart` gives."""
    return bool(re.search(r'-[0-9a-f]{20}$', learner))


def identity(name: str) -> str:
    """A learner's id from a file's name: also a name for the files of their results."""
    name = _COPY.sub('', written(name).removeprefix('submission-'))
    plain = normalize('NFKD', name).encode('ascii', 'ignore').decode()
    plain = re.sub(r'[^A-Za-z0-9._@-]+', '_', plain).lstrip('._@-')
    if len(plain) > 64 or any(ord(sign) > 127 and not normalize('NFKD', sign)[0].isascii() for sign in name):
        # What is left out told two learners apart.
        plain = f'{plain[:57].rstrip("_") or "x"}-{hashlib.sha256(name.encode()).hexdigest()[:6]}'
    return plain or 'unnamed'


def _time(seconds: float) -> str:
    """The time of a file; one of no year that there is counts as the nearest that is."""
    return stamp(datetime.fromtimestamp(min(max(int(seconds), 0), _LATEST), timezone.utc))


def changed(path: Path) -> str:
    """When a file was changed last; long ago, if nobody can tell."""
    try:
        return _time(path.lstat().st_mtime)
    except OSError:
        return _time(0)


def _newest(members: list[zipfile.ZipInfo]) -> str:
    """The time of a zip's newest member, which has no zone and is taken for UTC. `submit` writes the year 2000."""
    times = []
    for member in members:
        try:
            times.append(datetime(*member.date_time, tzinfo=timezone.utc))
        except ValueError:
            pass
    return stamp(max(times)) if times and max(times).year > 2000 else ''
