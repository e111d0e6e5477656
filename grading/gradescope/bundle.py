"""Makes the autograder zip: the course with its hidden tests, but without any answer, and Gradescope's two scripts."""

import io
import json
import os
import re
import zipfile
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from grading import learners_edition, sandbox
from grading.course import ChapterError, Course
from grading.gradescope.harness import CONFIG
from grading.reports import gradescope
from helpers import paths

SCRIPTS = ('setup.sh', 'run_autograder')
# Neither answers nor what only the authors of the course need.
LEFT_OUT = (
    'solutions',
    'build',
    'log',
    '.ci',
    '.github',
    'grading/tests',
    'grading/bench',
    'grading/authoring',
    'helpers/tests',
    'environment/tests',
)
ANSWERS = re.compile(r'grading/exercises/\w+/(mutants|alternatives)\.py')
DATE = (2000, 1, 1, 0, 0, 0)  # the same files give the same zip


class BundleError(Exception):
    """The zip cannot be made; the message says why."""


def bundle(
    output: Path, chosen: str, hidden: str = gradescope.HIDDEN, root: Path = paths.ROOT, chapters: Iterable[int] = ()
) -> list[str]:
    """Write the zip; returns the names of its files.

    :param chosen: the sandbox in which learner's code runs on Gradescope.
    :param hidden: when learners see the hidden tests, one of `gradescope.VISIBILITIES`.
    :param chapters: that are graded; all if there are none.
    :raises BundleError: a choice is unknown, or the zip cannot be written.
    """
    if chosen not in sandbox.LAUNCHERS:
        raise BundleError(f'there is no sandbox {chosen!r}; there are: {", ".join(sandbox.LAUNCHERS)}')
    if hidden not in gradescope.VISIBILITIES:
        raise BundleError(f'hidden tests can be {", ".join(gradescope.VISIBILITIES)}, not {hidden!r}')
    chapters = sorted(set(chapters))
    try:
        Course.here().part(chapters)
    except ChapterError as error:
        raise BundleError(str(error)) from None
    settings = {'sandbox': chosen, 'hidden': hidden, 'chapters': chapters}
    data = io.BytesIO()
    with zipfile.ZipFile(data, 'w') as archive:
        for name in SCRIPTS:
            _add(archive, name, (Path(__file__).parent / name).read_bytes(), True)
        _add(archive, CONFIG, (json.dumps(settings, indent=2) + '\n').encode(), False)
        for name in learners_edition.files(root, LEFT_OUT):
            if ANSWERS.fullmatch(name):
                continue
            path = root / name
            with suppress(FileNotFoundError):  # a scratch file of a program that runs at the same time
                _add(archive, f'course/{name}', path.read_bytes(), os.access(path, os.X_OK))
    try:
        output.parent.mkdir(parents=True, exist_ok=True)
        output.write_bytes(data.getvalue())
    except OSError as error:
        raise BundleError(f'{output} cannot be written: {error.strerror}') from None
    return archive.namelist()


def _add(archive: zipfile.ZipFile, name: str, content: bytes, executable: bool) -> None:
    info = zipfile.ZipInfo(name, DATE)
    info.create_system = 3  # Unix, for the permissions
    info.external_attr = (0o100755 if executable else 0o100644) << 16
    archive.writestr(info, content, zipfile.ZIP_DEFLATED)
