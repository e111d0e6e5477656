"""Answers that are packages: a folder which the learner has made in a terminal, in place of a cell.

`Exercise.folder` says where the package is, from the folder of the notebooks on. Its files are read as texts, within
bounds, and become a program of one cell, `PACKAGE = {path: text}`: the form in which the chapter's source holds the
solution. Nothing of it is executed here; tests take it as data (`learner.files`).

A folder on the learner's own machine and the members of a zip that a stranger has made meet the same bounds.
"""

import os
import re
import stat
from collections.abc import Container, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

from helpers.exercises import program
from helpers.exercises.manifest import Exercise
from helpers.exercises.program import InvalidExercise, NotAttempted

MAX_FILES = 100
MAX_FILE = 64 * 2**10  # bytes of one file
MAX_BYTES = 256 * 2**10  # of all files
MAX_PATH = 120  # characters of a path in the package
MAX_ENTRIES = 5000  # names that are looked at
MAX_DEPTH = MAX_PATH // 2  # of folders
NAME = 'PACKAGE'  # in the program
_PART = re.compile(r'[A-Za-z0-9_][A-Za-z0-9_.+-]*')  # of a path
_PRODUCTS = {'build', 'install', 'log'}  # at the top: of a build in the wrong folder
_CACHES = re.compile(r'__pycache__|.*\.egg-info|.*\.pyc')
_IN_ZIP = re.compile(r'(?:^|/)(\w+_ws/src/\w+)/(.+)', re.DOTALL)


@dataclass
class Package:
    """What is in a package's folder."""

    files: dict[str, bytes] = field(default_factory=dict)  # by path in the package, sorted
    left_out: list[str] = field(default_factory=list)  # what tools have made there, and hidden files
    saved: float = 0.0  # when a file was last changed, in seconds since 1970

    @property
    def size(self) -> int:
        """Bytes of all files."""
        return sum(map(len, self.files.values()))


def read(notebooks: Path, folder: str) -> Package:
    """Read the package in `folder`, which begins at the folder of the notebooks. Empty if there is none.

    Links are not followed, and what is no regular file is not opened.

    :raises InvalidExercise: it has something in it that cannot be handed in; the message says what to do.
    """
    found, top = Package(), notebooks
    for part in Path(folder).parts:
        top = top / part
        if top.is_symlink():
            raise InvalidExercise(f'{folder}: {part} is a link to another place. Make the folder itself there.')
    if not top.is_dir():
        if top.exists():
            raise InvalidExercise(f'{folder} is a file. A package is a folder.')
        return found
    seen = 0

    def unreadable(error: OSError) -> None:
        raise InvalidExercise(f'{folder}: {error.filename} cannot be read ({error.strerror}).')

    for parent, folders, names in os.walk(top, onerror=unreadable):
        place = Path(parent).relative_to(top)
        seen += len(folders) + len(names)
        if len(place.parts) > MAX_DEPTH:
            raise InvalidExercise(
                f'{folder} has folders within folders, more than {MAX_DEPTH} deep. Move what is no part of the package.'
            )
        if seen > MAX_ENTRIES:
            raise InvalidExercise(f'{folder} has more than {MAX_ENTRIES} files. Move what is no part of the package.')
        for name in sorted(folders):
            if _no_work(place / name):
                found.left_out.append(f'{(place / name).as_posix()}/')
            elif (Path(parent) / name).is_symlink():
                raise InvalidExercise(_of_link(place / name))
        folders[:] = sorted(name for name in folders if not _no_work(place / name))
        for name in sorted(names):
            if _no_work(place / name):
                found.left_out.append((place / name).as_posix())
            else:
                found.files[(place / name).as_posix()] = _content(Path(parent) / name, place / name, found)
    found.files = dict(sorted(found.files.items()))
    texts(found.files)
    return found


def texts(files: Mapping[str, bytes]) -> dict[str, str]:
    """The files of a package as texts, after a look at each name and at all sizes.

    :raises InvalidExercise: they cannot be handed in; the message says what to do.
    """
    if len(files) > MAX_FILES:
        raise InvalidExercise(
            f'Your package has {len(files)} files, more than {MAX_FILES}. Move what is no part of it to another place.'
        )
    if sum(map(len, files.values())) > MAX_BYTES:
        raise InvalidExercise(
            f'The files of your package have more than {MAX_BYTES // 2**10} kB together. Move what is no part of it to '
            'another place.'
        )
    found = {}
    for name, content in files.items():
        parts = name.split('/')
        if not all(_PART.fullmatch(part) for part in parts) or len(name) > MAX_PATH:
            raise InvalidExercise(
                f'A file of your package is called {name[:MAX_PATH]!r}. Use letters, digits and . _ + - in names, and '
                f'at most {MAX_PATH} characters.'
            )
        if any('/'.join(parts[:end]) in files for end in range(1, len(parts))):
            raise InvalidExercise(f'In your package, a file has the name of the folder of {name}. Rename one of them.')
        if len(content) > MAX_FILE:
            raise InvalidExercise(
                f'{name} in your package has more than {MAX_FILE // 2**10} kB. Move it to another place: a package '
                'here holds short texts.'
            )
        try:
            found[name] = content.decode('utf-8').replace('\r\n', '\n')
        except UnicodeDecodeError:
            raise InvalidExercise(
                f'{name} in your package is no text in UTF-8. Save it as one, or move it to another place.'
            ) from None
        if '\0' in found[name]:
            raise InvalidExercise(f'{name} in your package is no text: it has a null character in it.')
    return found


def source(exercise: Exercise, files: Mapping[str, str]) -> str:
    """The text of the cell that stands for a package."""
    lines = ''.join(f'    {name!r}: {text!r},\n' for name, text in sorted(files.items()))
    return f'# Exercise {exercise.id}: {exercise.title}\n{NAME} = {{\n{lines}}}\n'


def of_files(exercise: Exercise, files: Mapping[str, bytes]) -> program.Program:
    """The program of an exercise whose answer is this package.

    :raises InvalidExercise: the package cannot be used. :raises NotAttempted: there is none.
    """
    if not files:
        raise NotAttempted(
            f'There is no package yet: the folder {exercise.folder} is not there. Make it in a terminal, as the card '
            'says; there is no cell to fill in.'
        )
    text = source(exercise, texts(files))
    return program.Program(exercise, [{'label': 'your package', 'source': text, 'line': 1, 'required': True}], text)


def of_folder(exercise: Exercise, notebooks: Path) -> program.Program:
    """The program of an exercise whose answer is a package below the folder of the notebooks.

    :raises InvalidExercise: the package cannot be used. :raises NotAttempted: there is none.
    """
    package = read(notebooks, exercise.folder)
    if not package.files and (elsewhere := _elsewhere(notebooks, exercise)):
        raise NotAttempted(
            f'There is no package in {exercise.folder}, but there is one in {elsewhere}. Move it, with `mv`, then '
            'build again.'
        )
    if not package.files and (others := _others(notebooks, exercise)):
        top, name = Path(exercise.folder).parent, Path(exercise.folder).name
        raise NotAttempted(
            f'There is no package {name} in {top}; there is: {", ".join(others)}. This exercise asks for one that is '
            f'called {name}.'
        )
    return of_files(exercise, package.files)


def handed_in(exercise: Exercise, files: Iterable[str], unusable: Container[str] = ()) -> bool:
    """Whether these files, see `place`, have something of the exercise's package among them."""
    top = exercise.folder
    return bool(top) and (top in unusable or any(name.startswith(f'{top}/') for name in files))


def of_submission(
    exercise: Exercise, handed_in: Mapping[str, bytes], unusable: Mapping[str, str] = MappingProxyType({})
) -> program.Program:
    """The program of an exercise whose answer was handed in among these files, see `place`.

    :param unusable: for folders of packages, why they cannot be used.
    :raises InvalidExercise: the package cannot be used. :raises NotAttempted: there is none.
    """
    top = f'{exercise.folder}/'
    if exercise.folder in unusable:
        raise InvalidExercise(unusable[exercise.folder])
    files = {name.removeprefix(top): content for name, content in handed_in.items() if name.startswith(top)}
    if not files:
        raise NotAttempted(
            f'No package was handed in. `./course submit` packs {exercise.folder} together with the notebooks.'
        )
    return of_files(exercise, files)


def place(member: str) -> tuple[str, str] | None:
    """The folder and the path in it of a member of a zip, if it is work in a package: 'my_ws/src/patrol', 'setup.py'.

    A package's file stands among those that were handed in as 'my_ws/src/patrol/setup.py'.
    """
    match = _IN_ZIP.search(member)
    parts = match[2].split('/') if match else []
    if match is None or parts[0] in _PRODUCTS or any(part not in ('.', '..') and _is_made(part) for part in parts):
        return None  # as `read` leaves it out
    return match[1], match[2]


def _no_work(path: Path) -> bool:
    """Whether tools have made this, or it is hidden."""
    return _is_made(path.name) or len(path.parts) == 1 and path.name in _PRODUCTS


def _is_made(name: str) -> bool:
    """Whether a file or folder of this name is hidden, or made by tools wherever it is."""
    return name.startswith('.') or bool(_CACHES.fullmatch(name))


def _of_link(path: Path) -> str:
    return f'{path.as_posix()} in your package is a link. Put the file itself in its place.'


def _content(file: Path, path: Path, found: Package) -> bytes:
    """The bytes of a regular file, a few more than are allowed if there are as many."""
    if file.is_symlink():
        raise InvalidExercise(_of_link(path))
    try:
        # Without following a link, and without waiting for somebody at the other end of a pipe.
        with open(os.open(file, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK), 'rb') as opened:
            state = os.fstat(opened.fileno())
            if not stat.S_ISREG(state.st_mode):
                raise InvalidExercise(f'{path.as_posix()} in your package is no regular file. Move it away.')
            found.saved = max(found.saved, state.st_mtime)
            if len(found.files) >= MAX_FILES or found.size > MAX_BYTES:
                return b''  # too many or too much, which `texts` says with the numbers
            return opened.read(MAX_FILE + 1)
    except OSError as error:
        raise InvalidExercise(f'{path.as_posix()} in your package cannot be read: {error.strerror}.') from None


def _elsewhere(notebooks: Path, exercise: Exercise) -> str:
    """A folder near the right one that holds a package of this name; empty if there is none."""
    workspace, name = Path(exercise.folder).parts[0], Path(exercise.folder).name
    candidates = [
        *(f'{workspace}/{inside}' for inside in (name, f'src/src/{name}')),
        *(f'{found.name}/src/{name}' for found in sorted(notebooks.glob('*_ws'))),
        name,
        f'src/{name}',
        *sorted(found.relative_to(notebooks).as_posix() for found in notebooks.glob(f'*_ws_kept/*/{name}')),
        *(f'../{inside}' for inside in (exercise.folder, f'{workspace}/{name}', f'src/{name}', name)),
    ]
    for candidate in candidates:
        if candidate != exercise.folder and (notebooks / candidate / 'package.xml').is_file():
            return candidate
    return ''


def _others(notebooks: Path, exercise: Exercise) -> list[str]:
    """The folders of other packages beside the right one; a few of them."""
    top = notebooks / Path(exercise.folder).parent
    return sorted(found.parent.name for found in top.glob('*/package.xml'))[:5]
