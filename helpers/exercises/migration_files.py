"""The files of a migration: finds and reads the old notebooks, and writes the new ones as a whole, with a backup."""

import json
import re
import time
from pathlib import Path

from environment.setup import whole_file
from helpers import paths
from helpers.exercises import manifest, notebooks
from helpers.exercises.migration_report import MigrationError, MigrationReport

MAX_DEPTH = 100  # of lists and dictionaries within each other: what Python can copy
BACKUP = 'backup-'  # how the names of folders with earlier notebooks begin
_CHAPTER = re.compile(r'(\d\d)_\w+\.ipynb')


def chapters(folder: Path) -> list[Path]:
    return sorted(path for path in folder.glob('*.ipynb') if _CHAPTER.fullmatch(path.name))


def notebooks_of(old: Path) -> Path:
    for folder in (old, old / 'notebooks'):
        if folder.is_dir() and chapters(folder):
            return folder
    if old.is_file():
        raise MigrationError(
            f'{old} is a file: give the folder of the old course, or of its notebooks. A zip has to be unpacked first.'
        )
    raise MigrationError(
        f'{old} has no notebooks of the course, such as 03_nodes_and_topics.ipynb: give the folder of '
        'the old course, or of its notebooks.'
    )


def stubs(folder: Path) -> dict[str, str]:
    """Digests of the old version's stubs, by exercise; empty if its list of exercises is not beside the notebooks."""
    path = folder.resolve().parent / manifest.MANIFEST.relative_to(paths.ROOT)
    try:
        if not path.is_file() or path.stat().st_size > notebooks.MAX_BYTES:
            return {}
        exercises = manifest.load(path)
    except (manifest.ManifestError, OSError):
        return {}
    return {key: exercise.stub for key, exercise in exercises.items()}


def read(path: Path) -> dict:
    try:
        if path.is_symlink():  # the old folder may be anybody's, and this one's contents are copied
            raise notebooks.InvalidSubmission(f'{path.name} is a link to another place: put the file itself there.')
        data = notebooks.read_bytes(path)
        notebooks.parse(data, path.name)  # it is a notebook
    except notebooks.InvalidSubmission as error:
        raise MigrationError(f'{path.parent}: {error}') from None
    notebook = json.loads(data.decode('utf-8-sig'), parse_int=notebooks.whole_number)
    if _deeper_than(MAX_DEPTH, notebook):
        raise MigrationError(f'{path}: something in it is nested more than {MAX_DEPTH} deep. Clear its outputs.')
    for cell in notebook['cells']:
        if not isinstance(cell['source'], str):
            cell['source'] = ''.join(cell['source'])
        cell['source'] = cell['source'].replace('\r\n', '\n')
        if not isinstance(cell.get('metadata'), dict):
            cell['metadata'] = {}
        if cell.get('id') is None:
            cell.pop('id', None)
        pictures = cell.get('attachments', {})
        if not isinstance(pictures, dict) or not all(isinstance(one, dict) for one in pictures.values()):
            del cell['attachments']
    return notebook


def _deeper_than(most: int, value: object) -> bool:
    """Whether lists and dictionaries in a JSON value are within each other more than so many times."""
    level = [value]
    for _ in range(most + 1):
        level = [
            inner
            for one in level
            for inner in (one.values() if isinstance(one, dict) else one if isinstance(one, list) else ())
        ]
    return bool(level)


def write(report: MigrationReport, folder: Path, changed: dict[str, dict]) -> None:
    """Copy the notebooks that change into a new folder, then replace each as a whole."""
    import nbformat

    report.backup = folder / time.strftime(f'{BACKUP}%Y%m%d-%H%M%S')
    number = 1
    while report.backup.exists():
        number += 1
        report.backup = folder / f'{report.backup.name.partition("_")[0]}_{number}'
    try:
        report.backup.mkdir()
        for name in changed:
            (report.backup / name).write_bytes((folder / name).read_bytes())
        for name, notebook in changed.items():
            text = nbformat.writes(nbformat.from_dict(notebook)).rstrip('\n') + '\n'
            # Half of a surrogate pair is no UTF-8, and is written as JSON can say it.
            whole_file.write(folder / name, text.encode('utf-8', 'backslashreplace'))
            report.written.append(folder / name)
    except OSError as error:
        raise MigrationError(
            f'{error.filename or folder} cannot be written: {error.strerror}. What was there before '
            f'is in {report.backup}.'
        ) from None


def write_package(folder: Path, files: dict[str, bytes]) -> None:
    try:
        for name, content in files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(content)
    except OSError as error:
        raise MigrationError(f'{error.filename or folder} cannot be written: {error.strerror}.') from None
