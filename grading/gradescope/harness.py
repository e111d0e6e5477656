"""Grades the submission in Gradescope's folders: `python -m grading.gradescope.harness /autograder`.

It packs the learner's notebooks, runs the same `grade` command as anywhere else, and writes results/results.json.
Everything printed is for the instructor. A fault of the grader's gives no score and status 1, never a zero.
"""

import itertools
import json
import subprocess
import sys
import tempfile
import zipfile
from dataclasses import dataclass
from pathlib import Path

from environment.setup import whole_file
from grading.record import Record
from grading.reports import gradescope
from grading.submission import written
from helpers import paths
from helpers.exercises import package_answers

CONFIG = 'autograder.json'
MAX_NOTEBOOKS = 100


@dataclass(frozen=True)
class Config:
    """What `release --gradescope` put into the zip."""

    sandbox: str
    hidden: str  # when learners see the hidden tests: one of gradescope.VISIBILITIES
    chapters: tuple[int, ...] = ()  # that are graded; none: all

    @classmethod
    def load(cls, path: Path) -> 'Config':
        data = json.loads(path.read_text(encoding='utf-8'))
        return cls(str(data['sandbox']), str(data['hidden']), tuple(map(int, data.get('chapters', ()))))


def main(root: Path) -> int:
    """Grade; returns the exit status."""
    config = Config.load(root / 'source' / CONFIG)
    chapters = [word for number in config.chapters for word in ('--chapter', str(number))]
    with tempfile.TemporaryDirectory(prefix='gradescope-') as folder:
        archive = Path(folder, f'{_learner(root / "submission_metadata.json")}.zip')
        pack(root / 'submission', archive)
        output = Path(folder, 'out')
        for attempt in (1, 2):
            status = subprocess.run(
                [
                    sys.executable,
                    '-m',
                    'helpers.cli',
                    'grade',
                    str(archive),
                    '-o',
                    str(output),
                    '--sandbox',
                    config.sandbox,
                    *chapters,
                ],
                cwd=paths.ROOT,
            ).returncode
            record = next(
                (record for path in sorted(output.glob('results/*.json')) if (record := Record.load(path))), None
            )
            if record is None or record.status != 'grader_error':
                break
            print(f"attempt {attempt}: a fault of the grader's")
        log = output / 'run.log'
        if log.is_file():
            print(log.read_text(encoding='utf-8', errors='replace'))
    if record is None:
        print(f'grade ended with status {status} and without a result')
        return 1
    # `grade` has warned the instructor already, at the top of the output.
    warnings = ['Sandbox: none.'] if record.sandbox == 'none' else []
    whole_file.update(root / 'results' / 'results.json', gradescope.dumps(record, config.hidden, warnings))
    print(
        f'sandbox {record.sandbox}, seed {record.seed or "unknown"}, status {record.status}, '
        f'{"unknown" if record.score is None else format(record.score, "g")} of {record.points:g} points'
    )
    return 1 if record.status == 'grader_error' else 0


def pack(folder: Path, archive: Path) -> None:
    """Put the notebooks and packages of an upload, or of a repository, into one zip; links are left out.

    Notebooks at the top count; without one there, those in `notebooks/`; without one there, any. A zip that Gradescope
    left packed is taken as it is; one that it has unpacked has the packages beside the notebooks.
    """
    found = _notebooks(folder, '*') or _notebooks(folder / 'notebooks', '*') or _notebooks(folder, '**/*')
    packed = [path for path in sorted(folder.glob('*.zip')) if path.is_file() and not path.is_symlink()]
    if not found and len(packed) == 1:
        archive.write_bytes(packed[0].read_bytes())
        return
    # Names and dates are the learner's: what a zip cannot hold is not to end this.
    with zipfile.ZipFile(archive, 'w', zipfile.ZIP_DEFLATED, strict_timestamps=False) as target:
        for path in [*found[:MAX_NOTEBOOKS], *_of_packages(folder)]:
            target.write(path, written(path.relative_to(folder).as_posix()))


def _notebooks(folder: Path, pattern: str) -> list[Path]:
    return [path for path in sorted(folder.glob(f'{pattern}.ipynb')) if _is_handed_in(path, folder)]


def _of_packages(folder: Path) -> list[Path]:
    """The files of packages; no more than one of them too many, which grading then says."""
    inside = (path for path in folder.rglob('*') if package_answers.place(path.relative_to(folder).as_posix()))
    most = 2 * package_answers.MAX_FILE
    small = (path for path in inside if _is_handed_in(path, folder) and path.stat().st_size <= most)
    return sorted(itertools.islice(small, package_answers.MAX_FILES + 1))


def _is_handed_in(path: Path, folder: Path) -> bool:
    """Whether this is a regular file that neither is nor is in anything hidden or linked."""
    return path.is_file() and not any(
        part.is_symlink() or part.name.startswith('.')
        for part in [path, *path.parents]
        if part.is_relative_to(folder) and part != folder
    )


def _learner(metadata: Path) -> str:
    """An id for the submission: Gradescope's own numbers, no names."""
    try:
        users = json.loads(metadata.read_text(encoding='utf-8'))['users']
        return '-'.join(['gradescope', *(str(int(user['id'])) for user in users)])[:64]
    except (OSError, ValueError, KeyError, TypeError):
        return 'gradescope'


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1])))
