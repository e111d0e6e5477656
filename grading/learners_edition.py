"""The learner's edition: the course without solutions and without the instructor's half."""

import os
import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from grading import classroom as workflows
from helpers import paths
from helpers.exercises import manifest

LEFT_OUT = ('solutions', 'grading', '.ci', '.github', 'build', 'log')
_FILE_LEFT_OUT = re.compile(r'\.(pyc|part)$|^submission-.*\.zip$|^START\.md$|^\.progress\.json|^\.gitlab-ci\.yml$')
_WORKSPACE = re.compile(r'notebooks/[^/]+_ws(_kept)?/')  # what somebody has made there, perhaps a solution
_FOLDER_LEFT_OUT = {
    '.git',
    '.venv',
    '.home',
    '__pycache__',
    '.ipynb_checkpoints',
    '.pytest_cache',
    '.ruff_cache',
    '.mypy_cache',
    'build',
    'install',
    'log',
}


class Leak(Exception):
    """Something of the instructor's would be in the learner's edition; the message names it."""


class ReleaseError(Exception):
    """The edition cannot be made; the message names the remedy."""


def release(output: Path, root: Path = paths.ROOT, *, classroom: bool = False) -> list[str]:
    """Copy the learner's edition to `output`, which must be empty or missing; returns the paths of its files.

    :param classroom: add GitHub Classroom's workflow.
    :raises ReleaseError: `output` is not empty, or there are no notebooks.
    :raises Leak: a solution or a hidden test would be in it; nothing is written.
    """
    if output.exists() and (not output.is_dir() or any(output.iterdir())):
        raise ReleaseError(f'{output} is not empty: give a new folder')
    names = files(root)
    if not any(name.startswith('notebooks/') for name in names):
        raise ReleaseError('there are no notebooks: run ./course build')
    for name in list(names):
        try:
            _check(root / name, name, root)
        except FileNotFoundError:  # somebody else's scratch file
            names.remove(name)
    for name in names:
        target = output / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(root / name, target)
    if classroom:
        target = output / workflows.PATH
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(workflows.workflow(manifest.load().values()), encoding='utf-8')
        names.append(workflows.PATH)
    return names


def files(root: Path, left_out: Sequence[str] = LEFT_OUT) -> list[str]:
    """The files of the course, from git if it is there, without those in the folders `left_out`.

    Files that somebody else has just made there, such as a program's scratch files, may be gone when they are read.
    """
    listed = subprocess.run(
        ['git', '-C', root, 'ls-files', '-z', '--cached', '--others', '--exclude-standard'], capture_output=True
    )
    if listed.returncode == 0 and listed.stdout:
        names = listed.stdout.decode().split('\0')
    else:
        names = []
        for parent, folders, inside in os.walk(root):  # unlike rglob, it bears with a folder that vanishes meanwhile
            folders[:] = set(folders) - _FOLDER_LEFT_OUT
            names += [Path(parent, name).relative_to(root).as_posix() for name in inside]
    beginnings = tuple(f'{folder}/' for folder in left_out)
    return sorted(
        {
            name
            for name in names
            if name
            and not name.startswith(beginnings)
            and not _WORKSPACE.match(name)
            and not _FILE_LEFT_OUT.search(name.rpartition('/')[2])
            and (root / name).is_file()
            and not (root / name).is_symlink()
        }
    )


def _check(path: Path, name: str, root: Path) -> None:
    """Refuse a file with a hidden test or a solution in it."""
    try:
        text = path.read_text(encoding='utf-8')
    except UnicodeDecodeError:
        return
    if name.startswith('notebooks/') and 'BEGIN SOLUTION' in text:
        raise Leak(f'{name} holds a solution: run ./course build')
    for test in (root / 'grading' / 'exercises').glob('*/hidden.py'):
        # A test's first function is its own; imports and helpers may be anybody's.
        if found := re.search(r'^def test_\w+\(.*\):\n(?: .*\n|\n)+', test.read_text(encoding='utf-8'), re.MULTILINE):
            if found[0].strip() in text:
                raise Leak(f'{name} holds a test of {test.relative_to(root)}')
