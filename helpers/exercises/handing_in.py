"""`submit()`: pack notebooks, and packages that are answers, into one file to hand in, after a look at what passes."""

import getpass
import io
import json
import os
import re
import time
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from environment.setup import whole_file
from helpers import paths

LEARNER = re.compile(r'[A-Za-z0-9][A-Za-z0-9._@-]{0,63}')
FORMAT = 1  # of submission.json


class SubmissionError(Exception):
    """Nothing can be handed in; the message names the lack and the remedy."""


@dataclass
class Packed:
    """A file to hand in, and what is in it."""

    path: Path
    learner: str
    folder: Path  # of the notebooks
    exercises: list = field(default_factory=list)  # ExerciseResult
    warnings: list[str] = field(default_factory=list)  # what is not in it, or not as it was checked
    packages: dict[str, Any] = field(default_factory=dict)  # by folder: `helpers.exercises.package_answers.Package`
    cells: dict[str, list] = field(default_factory=dict)  # by notebook: its NotebookCells

    def lists(self) -> list[str]:
        """What is in it beside the notebooks, and what is not: lines for the learner."""
        told = []
        for folder, package in self.packages.items():
            told.append(f'{folder}: {len(package.files)} files, {package.size / 1000:.1f} kB')
            told += [f'    {name}' for name in package.files]
            if package.left_out:
                shown, more = package.left_out[:8], len(package.left_out) - 8
                told.append(f'    left out: {", ".join(shown)}' + (f' and {more} more' if more > 0 else ''))
        return told + self.warnings


def submit(learner: str | None = None) -> None:
    """Pack the saved notebooks and show what passes, as `./course submit` does. Save this notebook first."""
    if 'COURSE_RUNNER' in os.environ:
        return
    from helpers.exercises import result_display

    try:
        packed = pack(learner)
        print(
            f'Packed for {packed.learner}: {packed.path.name}. Hand in this file. '
            'It holds the notebooks as they were last saved'
            f'{", and the packages that are listed." if packed.packages else "."}\n'
        )
        for results in tested(packed):
            print(result_display.plain(results))
        print('', *packed.lists(), sep='\n')
    except SubmissionError as error:
        print(error)


def pack(learner: str | None = None, output: Path | None = None, *, notebooks_folder: Path = paths.NOTEBOOKS) -> Packed:
    """Write the zip file.

    Outputs of cells are left out. Packages that are answers are in it, as far as they can be handed in. The same work
    gives the same bytes.

    :raises SubmissionError: no notebook of the course is there, one cannot be read, or the learner's id is unusable.
    """
    from helpers.exercises import manifest, notebooks, package_answers, program

    learner = learner or _login()
    if not LEARNER.fullmatch(learner):
        raise SubmissionError(f'{learner!r} cannot be an id: use letters, digits and . _ @ -, for example --id ada.')
    output = output or paths.ROOT / f'submission-{learner}.zip'
    exercises = manifest.load()
    names = dict.fromkeys(exercise.notebook for exercise in exercises.values())
    found = {name: notebooks_folder / name for name in names if (notebooks_folder / name).is_file()}
    if not found:
        raise SubmissionError(f'no notebook of the course is in {notebooks_folder}: save your work there.')
    packed = Packed(output, learner, notebooks_folder)
    members, saved = {}, 0.0
    for name, path in found.items():
        try:
            packed.cells[name] = notebooks.read(path)
        except notebooks.InvalidSubmission as error:
            raise SubmissionError(str(error)) from None
        members[name] = _without_outputs(path)
        saved = max(saved, path.stat().st_mtime)
    packed.warnings += _in_copies(notebooks_folder, [cell for cells in packed.cells.values() for cell in cells])
    for exercise in exercises.values():
        if not exercise.folder:
            continue
        try:
            package = package_answers.read(notebooks_folder, exercise.folder)
        except program.InvalidExercise as error:
            packed.warnings.append(f'The package of exercise {exercise.id} is not in the file. {error}')
            continue
        if package.files:
            packed.packages[exercise.folder] = package
            members |= {f'{exercise.folder}/{name}': content for name, content in package.files.items()}
            saved = max(saved, package.saved)
    label = {
        'format': FORMAT,
        'learner': learner,
        'saved': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime(saved)),
    }  # of several zips the latest counts
    members['submission.json'] = json.dumps(label, indent=2).encode()
    _write(output, members)
    return packed


def tested(packed: Packed, say: Callable[[str], None] = lambda test: None) -> Iterator[list]:
    """Run the visible tests of what is packed, and yield the results of one notebook after the other.

    Who stops them has a file to hand in all the same.

    :param say: is told each test that has finished.
    """
    from helpers.exercises import manifest
    from helpers.runner import session

    exercises = manifest.load().values()
    for name, cells in packed.cells.items():
        mine = [exercise for exercise in exercises if exercise.notebook == name]
        results = session.run(cells, mine, session.Options(processes=2, folder=packed.folder), say).exercises
        packed.exercises += results
        yield results
    packed.warnings[:0] = _not_saved(packed.exercises, packed.folder)


def _not_saved(results: list, folder: Path) -> list[str]:
    """What is said of exercises that a check has found solved, but not as the notebook lies on the disk.

    JupyterLab saves every 20 seconds (another server than that of the course: every two minutes), and a check judges
    the cell that was run.
    """
    from helpers.exercises import manifest, progress_file

    marks, exercises = progress_file.load(folder), manifest.load()
    return [
        f'Exercise {result.id}: its last check found it solved, and what is saved does not pass. Save '
        f'{exercises[result.id].notebook} (Ctrl+S), and submit again.'
        for result in results
        if not result.passed and result.id in marks and marks[result.id].passed
    ]


def _in_copies(folder: Path, handed_in: list) -> list[str]:
    """What is said of notebooks with other names, such as JupyterLab's copies, if they have answers of their own."""
    from helpers.exercises import manifest, notebooks, program

    exercises = manifest.load().values()
    there = {cell.source.strip() for cell in handed_in}
    said = []
    for path in sorted(set(folder.glob('*.ipynb')) - {folder / exercise.notebook for exercise in exercises}):
        try:
            cells = notebooks.read(path)
        except notebooks.InvalidSubmission:
            continue
        own = [
            exercise.id
            for exercise in exercises
            if any(
                program.is_answer(cell, exercise) and cell.source.strip() not in there
                for cell in program.of_exercise(cells, exercise)
            )
        ]
        if own:
            said.append(
                f'{path.name} is not in the file: only notebooks with the names that the course gave them are handed '
                f'in. It has other cells of {", ".join(own)}: copy into those notebooks what you want to hand in, save '
                'them, and submit again.'
            )
    return said


def _login() -> str:
    try:
        return getpass.getuser()
    except (KeyError, OSError):
        raise SubmissionError('your login name is unknown: give an id with --id.') from None


def _without_outputs(path: Path) -> bytes:
    from helpers.exercises import notebooks

    notebook = notebooks.document(notebooks.read_bytes(path), path.name)
    for cell in notebook['cells']:
        if cell.get('cell_type') == 'code':
            cell['outputs'], cell['execution_count'] = [], None
    # Half of a surrogate pair is no UTF-8, and is written as JSON can say it.
    return json.dumps(notebook, indent=1, ensure_ascii=False).encode('utf-8', 'backslashreplace')


def _write(output: Path, members: dict[str, bytes]) -> None:
    data = io.BytesIO()
    with zipfile.ZipFile(data, 'w', zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0)), content, zipfile.ZIP_DEFLATED)
    try:
        output.parent.mkdir(parents=True, exist_ok=True)
        whole_file.write(output, data.getvalue())
    except OSError as error:
        raise SubmissionError(f'{output} cannot be written: {error.strerror}.') from None
