"""Finds the submissions among files and folders, as learners, Moodle, Canvas and GitHub Classroom name them.

Whose a submission is, is told by the name that a learning platform or the instructor gave to its file or folder. The id
inside a zip is the learner's own word: it counts only where no other submission comes under that name.

| form                                                    | learner                            |
|---------------------------------------------------------|------------------------------------|
| `NAME.zip`, `submission-NAME.zip`, `NAME.ipynb`, `NAME/` | NAME; a zip's own id where it has one |
| Moodle: `Jane Doe_123_assignsubmission_file/…`          | `Jane_Doe_123`                     |
| Canvas: `doejane_LATE_123_456_anything.zip`             | `doejane_123`                      |
| GitHub Classroom: `task-submissions/task-jane/notebooks/` | `jane`                             |
"""

import re
import zipfile
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path

from grading import reader
from grading.record import Attempt
from grading.submission import (
    Submission,
    Unusable,
    apart,
    changed,
    identity,
    is_apart,
    is_notebook,
    own_name,
    read,
    written,
)

_CHAPTER = re.compile(r'\d\d_.*\.ipynb')  # a file name; downloads add words such as " (1)" behind the number
_MOODLE = re.compile(r'(?P<who>.+_\d+)_assignsubmission_(file|onlinetext)(_(?P<file>.*))?')
_CANVAS = re.compile(r'(?P<name>[^_]+)_(LATE_)?(?P<number>\d+)_\d+_(?P<file>.+)')
_DEEPEST = 4  # folders below the one that was given
MOST = 30  # files and folders of one learner's that are read: the newest ones of a folder
MOST_TOO_MUCH = 2  # and so many of them may be such that take too much time or memory


def find(paths: Iterable[Path], skipped: list[Path] | None = None) -> list[Submission]:
    """Read the submissions at `paths`: the latest of each learner, sorted by learner, with the earlier ones on record.

    :param skipped: is given the files and folders that hold no submission. One of several paths stops no other: which
        files there are, and what is in them, may be up to learners.
    :raises Unusable: a path does not exist, or none holds a submission.
    """
    found: dict[Path, Submission] = {}
    skipped, why = [] if skipped is None else skipped, []
    readings = _Readings()
    for path in paths:
        if not path.exists() and not path.is_symlink():
            raise Unusable(f'{path} does not exist')
        try:
            for submission in _at(path, skipped, readings):
                found.setdefault(submission.source.resolve(), submission)
        except (Unusable, OSError) as error:
            skipped[:] = [one for one in skipped if one != path] + [path]
            why.append(error if isinstance(error, Unusable) else Unusable(f'{path} cannot be read: {error.strerror}'))
    if why and not found:
        raise why[0]
    readings.note(found.values())
    _name(list(found.values()))
    _note_copies(list(found.values()))
    learners: dict[str, list[Submission]] = defaultdict(list)
    for submission in found.values():
        learners[submission.learner].append(submission)
    return [_latest(learners[learner]) for learner in sorted(learners)]


def _at(path: Path, skipped: list[Path], readings: '_Readings') -> list[Submission]:
    if path.is_file():
        if path.suffix.lower() == '.zip' and _of_a_class(path):
            raise Unusable(f'{path} holds the submissions of several learners: unpack it, and give the folder')
        return readings.read(path)
    chapters = [child for child in _children(path) if child.is_file() and _CHAPTER.match(child.name)]
    archives = [child for child in _children(path) if child.is_file() and child.suffix.lower() == '.zip']
    if chapters and archives and not _owner(path):
        raise Unusable(
            f"{path} holds both {chapters[0].name}, as one learner's folder does, and {archives[0].name}: "
            "put each learner's notebooks into a folder of their own"
        )
    found = readings.read(path) if chapters and not archives else list(_below(path, _owner(path), skipped, 0, readings))
    if not found:
        raise Unusable(f'{path} holds no submission: expected notebooks, or zip files and folders of learners')
    return found


def _of_a_class(path: Path) -> bool:
    """Whether this file, which the instructor named, is the zip in which a platform delivers all submissions."""
    try:
        return bool(reader.ask('grading.submissions:of_a_class', path)[0])
    except reader.TooMuch:
        return False  # reading it says what is wrong


def of_a_class(path: Path):
    """What `_of_a_class` says; in a child process."""
    try:
        with zipfile.ZipFile(path) as archive:
            names = {name.partition('/')[0] for name in archive.namelist()}
    except Exception:  # noqa: BLE001 - zipfile raises many types
        names = set()
    return sum(bool(_MOODLE.fullmatch(name) or _CANVAS.fullmatch(name)) for name in names) > 1, ()


def _below(folder: Path, owner: str, skipped: list[Path], depth: int, readings: '_Readings') -> Iterator[Submission]:
    """The submissions in a folder: all are `owner`'s, if there is one."""
    loose: dict[str, list[Path]] = defaultdict(list)  # notebooks of one learner that lie beside those of others
    empty = True
    mine_of = {child: owner or _owner(child) for child in _children(folder)}
    # Of one learner's not all may be read: the newest ones are.
    for child in sorted(mine_of, key=lambda one: changed(one) if mine_of[one] else '', reverse=True):
        mine = mine_of[child]
        if child.is_symlink() and (owner or depth):
            continue  # what a learner made is not followed
        try:
            if is_notebook(child.name) and mine and not child.is_dir():
                loose[mine].append(child)
            elif (found := _of_child(child, mine, owner, skipped, depth, readings)) is not None:
                yield from found
            else:
                skipped.append(child)
                continue
        except (Unusable, OSError):  # one that is no file, or is protected, stops nobody else's
            yield _unreadable(child, mine)
        empty = False
    for mine, notebooks in loose.items():
        try:
            yield from _together(mine, notebooks, readings)
        except (Unusable, OSError):
            yield _unreadable(notebooks[0], mine)
    if empty and not owner:
        skipped.append(folder)


def _of_child(
    child: Path, mine: str, owner: str, skipped: list[Path], depth: int, readings: '_Readings'
) -> list[Submission] | None:
    """The submissions in a file or folder, `mine` if that is somebody's; None if it is nothing that can hold any."""
    if child.is_dir():
        work = next((place for place in (child, child / 'notebooks') if _has_notebooks(place)), None)
        if work is not None and not (mine and _archives(child)):
            return readings.read(work, mine or own_name(child))
        inner = list(_below(child, mine, skipped, depth + 1, readings)) if depth < _DEEPEST else []
        if mine and not owner and not inner and depth < _DEEPEST:
            return readings.read(child, mine)  # a learner's folder, in which nothing can be used
        return inner
    if child.suffix.lower() == '.zip' or is_notebook(child.name):
        return readings.read(child, mine)
    return None


def _unreadable(path: Path, owner: str) -> Submission:
    """A submission that cannot be read: its learner's matter."""
    own = owner or own_name(path)
    problem = 'What was handed in cannot be read: it is no regular file, or it is protected. Hand in a new zip.'
    return Submission(identity(own), path, problem=problem, own=own, platform=bool(owner), handed_in=changed(path))


def _children(folder: Path) -> list[Path]:
    return sorted(child for child in folder.iterdir() if not child.name.startswith(('.', '__MACOSX')))


def _has_notebooks(folder: Path) -> bool:
    return (
        folder.is_dir()
        and not folder.is_symlink()
        and any(is_notebook(inner.name) and inner.is_file() for inner in folder.iterdir())
    )


def _archives(folder: Path) -> bool:
    return any(inner.suffix.lower() == '.zip' for inner in _children(folder))


def _owner(path: Path) -> str:
    """The learner whom a learning platform names in the name of a file or folder, as written; empty if none does."""
    if match := _MOODLE.fullmatch(path.name):
        return written(match['who'])
    if (match := _CANVAS.fullmatch(path.name)) and not path.is_dir():
        return written(f'{match["name"]}_{match["number"]}')
    task = path.parent.name.removesuffix('-submissions')
    if path.is_dir() and task != path.parent.name and path.name.startswith(f'{task}-'):
        return written(path.name[len(task) + 1 :])
    return ''


class _Readings:
    """Reads what is found, but of one learner's only so much that nobody else has to wait for long."""

    def __init__(self) -> None:
        self._read: Counter[str] = Counter()  # by the name of the owner
        self._too_much: Counter[str] = Counter()
        self._left: Counter[str] = Counter()

    def read(self, path: Path, owner: str = '') -> list[Submission]:
        """What is at this path, `owner`'s if there is one; nothing if so much of theirs was read already."""
        owner = owner or _owner(path)
        if not self.may_read(owner):
            return []
        submission = self.counted(owner, path)
        if owner:
            submission.learner, submission.own, submission.platform = identity(owner), owner, True
        return [submission]

    def may_read(self, owner: str) -> bool:
        """Whether one more of this learner's is read; it counts then."""
        if owner and (self._read[owner] >= MOST or self._too_much[owner] >= MOST_TOO_MUCH):
            self._left[owner] += 1
            return False
        self._read[owner] += 1
        return True

    def counted(self, owner: str, path: Path) -> Submission:
        """Read one of this learner's."""
        submission = read(path)
        self._too_much[owner] += submission.problem == reader.TOO_MUCH
        return submission

    def note(self, found: Iterable[Submission]) -> None:
        """Note on submissions that others of the same learner were not read."""
        for submission in found:
            if left := self._left[submission.own]:
                submission.notes.append(
                    f'{left} more that {submission.own} handed in were not read: there are more than {MOST}, or '
                    'reading some of them took too much time or memory'
                )


def _together(owner: str, notebooks: list[Path], readings: _Readings) -> list[Submission]:
    """One submission of notebooks that the platform delivered one by one. One that is wrong concerns itself only."""
    if len(notebooks) == 1:
        return readings.read(notebooks[0], owner)
    parts = {path: readings.counted(owner, path) for path in notebooks if readings.may_read(owner)}
    if not parts:
        return []
    notebooks = sorted(parts)
    made = Submission(
        identity(owner), notebooks[0], own=owner, handed_in=max(part.handed_in for part in parts.values())
    )
    for path in notebooks:
        part = parts[path]
        match = _CANVAS.fullmatch(path.name) or _MOODLE.fullmatch(path.name)
        name = match and match['file'] or path.name
        for why in filter(None, (part.problem, *part.unusable.values())):
            made.unusable[name] = why
        for data in part.files.values():
            if made.files.setdefault(name, data) != data:
                made.unusable[name] = f'There are two notebooks called {name}: hand in one.'
    return [made]


def _name(found: list[Submission]) -> None:
    """Let the ids inside zips count where nobody else has a claim to them, and tell learners apart."""
    named = {
        submission.learner
        for submission in found
        if submission.platform or submission.label in ('', submission.learner)
    }
    claims: dict[str, set[str]] = defaultdict(set)
    for submission in found:
        if not submission.platform and submission.label not in ('', submission.learner):
            claims[submission.label].add(submission.own)
    for submission in found:
        name, label = submission.learner, submission.label
        if label in ('', name) or submission.platform:
            continue
        if is_apart(label):
            submission.notes.append(
                f"submission.json says that it is {label}'s, which is an id that only the grader gives, to tell names "
                f"apart: taken as {name}'s, by the name of the file"
            )
        elif label in named:
            submission.notes.append(
                f"submission.json says that it is {label}'s, whose own submission is there, too: "
                f"taken as {name}'s, by the name of the file"
            )
        elif len(claims[label]) > 1:
            submission.notes.append(
                f"{', '.join(sorted(claims[label]))} all say that they are {label}'s: taken as "
                f"{name}'s, by the name of the file. If they are of one learner, give the files "
                'one name, in folders of their own'
            )
        else:
            submission.learner = label
    _tell_apart(found)


def _tell_apart(found: list[Submission]) -> None:
    """Different names that give the same id, such as José and Jose, are different learners."""
    owners: dict[str, list[Submission]] = defaultdict(list)
    for submission in found:
        owners[submission.learner].append(submission)
    for learner, theirs in owners.items():
        names = {submission.own for submission in theirs}
        if len(names) < 2:
            continue
        for submission in theirs:
            others = ', '.join(sorted(names - {submission.own}))
            if submission.own != learner:
                submission.learner = apart(submission.own)
            submission.notes.append(
                f'{submission.own} and {others} give the same id, {learner}, and are taken for '
                f'different learners: this one is {submission.learner}'
            )


def _note_copies(found: list[Submission]) -> None:
    """Zips that several learners handed in, but one of them packed: a platform names each after who handed it in."""
    users: dict[str, set[str]] = defaultdict(set)
    for submission in found:
        users[submission.label].add(submission.learner)
    for submission in found:
        others = users[submission.label] - {submission.learner}
        if submission.label and submission.platform and others:
            submission.notes.append(
                f'{", ".join(sorted(others))} handed in a zip with the same id inside, {submission.label}'
            )


def _latest(attempts: list[Submission]) -> Submission:
    """The submission that counts: the latest, by the time of handing in, then by its path."""
    *earlier, latest = sorted(attempts, key=lambda one: (one.handed_in, str(one.source)))
    if earlier and earlier[-1].handed_in == latest.handed_in and earlier[-1].digest() != latest.digest():
        latest.notes.append(f'{earlier[-1].source.name} has the same time: {latest.source.name} counts')
    own = latest.digest()
    latest.earlier = [Attempt(one.source.name, one.digest(), one.handed_in) for one in earlier if one.digest() != own]
    return latest
