"""What submissions are graded against, and digests of it: a mark is up to date while they are the same."""

import hashlib
import sys
from collections.abc import Container, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from grading import sandbox
from helpers import paths
from helpers.exercises import manifest
from helpers.exercises.manifest import Exercise
from helpers.runner import session

HIDDEN = Path(__file__).resolve().parent / 'exercises'
# What can change a mark, below the root of the course: rather too much than too little. Tests are looked at one by one,
# see `Course.digests_at`.
_GRADER = (
    'helpers',
    'environment/ros2_ws',
    'environment/requirements.lock',
    'grading/sandbox',
    'grading/reference.py',
    'grading/unit.py',
    'grading/course.py',
    'grading/submission.py',
    'grading/reader.py',
)
# And what of it cannot: commands, web pages, the project's own tests, and what Python or a build leaves behind.
_NO_MATTER = ('helpers/checks', 'helpers/cli', 'helpers/tests', 'helpers/show/views/web')
_CACHES = {'__pycache__', '.pytest_cache', '.ipynb_checkpoints'}
_LEFT_BEHIND = _CACHES | {'build', 'install', 'log', 'test', 'tests'}
_NO_TESTS = {'exercises.json', 'mutants.py', 'alternatives.py'}  # an exercise's row counts for that exercise alone


class ChapterError(Exception):
    """A chapter is chosen that is not in the course."""


@dataclass(frozen=True)
class Course:
    """What submissions are graded against."""

    exercises: tuple[Exercise, ...]
    visible: Path = session.VISIBLE
    hidden: Path = HIDDEN
    sandbox: str = sandbox.DEFAULT
    test_timeout: float = session.TEST_TIMEOUT

    @classmethod
    def here(cls) -> 'Course':
        """The course of this checkout."""
        return cls(tuple(manifest.load().values()))

    def part(self, chapters: Sequence[int]) -> 'Course':
        """The same with the exercises of these chapters only; all of it if there are none.

        :raises ChapterError: a chapter has no exercise.
        """
        known = {exercise.chapter for exercise in self.exercises}
        if unknown := sorted(set(chapters) - known):
            raise ChapterError(
                f'there is no exercise in chapter {unknown[0]}; there are chapters {", ".join(map(str, sorted(known)))}'
            )
        return replace(self, exercises=tuple(one for one in self.exercises if not chapters or one.chapter in chapters))

    @cached_property
    def digests(self) -> dict[str, str]:
        """By exercise, a SHA-256 of all that its mark depends on besides the submission.

        A change of `test_3_1.py` touches exercise 3.1; one of a file that tests share, or of the grader, touches all.
        """
        return self.digests_at(paths.ROOT)

    def digests_at(self, root: Path) -> dict[str, str]:
        """The same, with the grader that is below `root`."""
        grader = hashlib.sha256(repr((self.sandbox, self.test_timeout, sys.version_info[:2])).encode())
        for place in _GRADER:
            for path in _files(root / place, _LEFT_BEHIND, [root / other for other in _NO_MATTER]):
                if path.suffix != '.md':
                    grader.update(_content(path, root))
        tests = [
            (manifest.tested_in(path), _content(path, folder))
            for folder in (self.visible, self.hidden)
            for path in _files(folder, _CACHES)
            if path.name not in _NO_TESTS
        ]
        digests = {}
        for exercise in self.exercises:
            digest = grader.copy()
            digest.update(repr(replace(exercise, rules=())).encode())
            for tested, content in tests:
                if tested in (None, exercise.id):
                    digest.update(content)
            digests[exercise.id] = digest.hexdigest()
        return digests

    @property
    def digest(self) -> str:
        """SHA-256 of tests and grader, for all exercises together."""
        return hashlib.sha256(''.join(self.digests.values()).encode()).hexdigest()

    def packed(self) -> 'Course':
        """The same, with the paths of this checkout relative to it: for another machine, and that one's `unpacked`."""
        return replace(
            self,
            **{
                name: path.relative_to(paths.ROOT)
                for name in ('visible', 'hidden')
                if (path := getattr(self, name)).is_relative_to(paths.ROOT)
            },
        )

    def unpacked(self) -> 'Course':
        """The same, with the paths of this checkout."""
        return replace(self, visible=paths.ROOT / self.visible, hidden=paths.ROOT / self.hidden)


def _files(place: Path, names: Container[str], left_out: Sequence[Path] = ()) -> Iterator[Path]:
    """The files of a folder, or the file itself, in the same order on every machine; none called one of `names`."""
    if place.is_file():
        yield place
    elif place.is_dir() and place not in left_out:
        for path in sorted(place.iterdir()):
            if path.name not in names:
                yield from _files(path, names, left_out)


def _content(path: Path, folder: Path) -> bytes:
    """A file's path, whether it may be executed, and its content."""
    executable = bool(path.stat().st_mode & 0o100)
    return f'{path.relative_to(folder).as_posix()}\0{executable}\0'.encode() + path.read_bytes() + b'\0'
