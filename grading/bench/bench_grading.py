"""Grading: a submission of two pure functions and a talker, in the sandbox, from start to gradebook.

`start` is once per run of grade, the parts are per submission. Every mark is verified. Besides, the solutions of the
whole course as one learner's submission, alone on the machine, from start to gradebook.

The other graders get the same answers with a test for each. The course then grades as they do, one submission at a
time, in a program that is started for it; see `grading.bench.peers` for what else differs.
"""

import ast
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import psutil

from grading import grading_run, reference, sandbox, variants
from grading.authoring import chapter as chapters
from grading.authoring import notebook_pair as authored
from grading.bench import Measurement, timed_sheet
from grading.course import Course
from grading.sandbox import station
from grading.submission import Submission
from helpers import paths
from helpers.exercises.manifest import Exercise
from helpers.exercises.notebooks import NotebookCell, parse
from helpers.runner import session

COUNTS = (1, 10, 50)
JOBS = 2
COMPARED = 10  # submissions that the other graders get, too
NOTEBOOK = '91_sheet.ipynb'
_TESTS = {
    'mean': "    expect(learner.call('mean', [1, 2, 6]) == 3, 'The mean of 1, 2 and 6 is 3.')",
    'clamp': "    expect(learner.call('clamp', 7, 0, 5) == 5, '7 is above 5.')",
    'Talker': (
        "    heard = learner.listen('/chatter', String)\n    learner.start('Talker')\n    learner.run(1.0)\n"
        "    expect(heard.data == ['hello'] * 10, f'{len(heard)} messages came.')"
    ),
}


def measure() -> Iterator[Measurement]:
    """Yield wall time and peak memory of runs of grade, the split of one session's time, and times of other graders.

    :raises RuntimeError: the sandbox does not work here, or a mark is not full.
    """
    if problem := sandbox.problem():
        raise RuntimeError(problem)
    with tempfile.TemporaryDirectory(prefix='course-bench-') as folder:
        course = _course(Path(folder))
        for count in COUNTS:
            seconds, memory = _run(course, count, Path(folder, str(count)))
            many = f'{count} submissions, {JOBS} at a time' if count > 1 else '1 submission'
            yield Measurement(f'{many}: per submission', seconds / count, 's')
            yield Measurement(f'{many}: per exercise', seconds / count / len(timed_sheet.NAMES), 's')
            yield Measurement(f'{many}: peak memory', memory / 2**20, 'MiB')
        yield from _parts(course)
        yield from _whole(Path(folder, 'whole'))
    from grading.bench.peers import timing

    for peer in timing.PEERS:
        ours = _program(COMPARED) / COMPARED
        theirs = timing.seconds(peer, COMPARED) / COMPARED
        yield Measurement(f'{COMPARED} submissions, one at a time: per submission', ours, 's', peer, theirs)


def _program(count: int) -> float:
    """Seconds of a program that grades `count` submissions one after the other, its start included."""
    begin = time.perf_counter()
    done = subprocess.run(
        [sys.executable, '-m', 'grading.bench.bench_grading', str(count)],
        cwd=paths.ROOT,
        timeout=600,
        capture_output=True,
        text=True,
    )
    if done.returncode:
        raise RuntimeError(f'grading in a program of its own failed: {done.stderr[-800:]}')
    return time.perf_counter() - begin


def _course(folder: Path) -> Course:
    exercises = []
    for number, name in enumerate(timed_sheet.NAMES, 1):
        path = folder / 'exercises' / f'91_{number}' / 'hidden.py'
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"""\
import pytest
from std_msgs.msg import String
from helpers.runner import expect

pytestmark = pytest.mark.exercise('91.{number}')


def test_{name.lower()}(learner):
    \"\"\"It works.\"\"\"
{_TESTS[name]}
""")
        exercises.append(Exercise(f'91.{number}', 91, NOTEBOOK, name, 1, (name,), f'ex-91-{number}', ''))
    (folder / 'checks').mkdir()
    return Course(tuple(exercises), folder / 'checks', folder / 'exercises')


def _notebook(variant: int) -> bytes:
    """A right notebook; each variant is another file, or it would be graded once."""
    import nbformat

    notebook = nbformat.v4.new_notebook(
        cells=[
            nbformat.v4.new_code_cell(f'# Exercise 91.{number}: {name}\n{answer}\n# {variant}', id=f'ex-91-{number}')
            for number, (name, answer) in enumerate(zip(timed_sheet.NAMES, timed_sheet.ANSWERS, strict=True), 1)
        ]
    )
    return nbformat.writes(notebook).encode()


def _run(course: Course, count: int, output: Path, jobs: int = JOBS) -> tuple[float, int]:
    """Grade `count` submissions with cold servers; returns seconds and the peak of memory in bytes."""
    station.close()
    works = [
        Submission(f'learner{number:03}', Path(NOTEBOOK), {NOTEBOOK: _notebook(number)}) for number in range(count)
    ]
    with _Peak() as peak:
        begin = time.perf_counter()
        records = grading_run.grade(works, course, output, jobs)
        seconds = time.perf_counter() - begin
    _verify(record.score == record.points for record in records)
    return seconds, peak.bytes


def _whole(output: Path) -> Iterator[Measurement]:
    """The solutions of all chapters, graded alone with cold servers."""
    course = Course.here()
    work = Submission('learner', output, solved(course))
    station.close()
    begin = time.perf_counter()
    records = grading_run.grade([work], course, output, JOBS)
    seconds = time.perf_counter() - begin
    _verify(record.score == record.points for record in records)
    yield Measurement(f'all {len(course.exercises)} exercises, 1 submission, {JOBS} at a time', seconds, 's')


def solved(course: Course) -> dict[str, bytes]:
    """What a learner hands in whose answers are the course's solutions: notebooks, and the files of packages."""
    notebooks = {exercise.notebook for exercise in course.exercises}
    files = {
        name: authored.dumps(authored.solved(chapters.read(path))).encode()
        for path in chapters.sources(reference.SOLUTIONS)
        if (name := f'{path.stem}.ipynb') in notebooks
    }
    cells = variants.solved_cells(reference.SOLUTIONS)
    for exercise in course.exercises:
        if exercise.folder:
            [assigned] = [line for line in ast.parse(cells[exercise.id]).body if isinstance(line, ast.Assign)][:1]
            package = ast.literal_eval(assigned.value)
            files |= {f'{exercise.folder}/{name}': text.encode() for name, text in package.items()}
    return files


def _parts(course: Course) -> Iterator[Measurement]:
    """Where the time of one session goes, best of five on warm servers."""
    cells: list[NotebookCell] = parse(_notebook(0), NOTEBOOK)
    options = session.Options(hidden=course.hidden, visible=course.visible, launcher=sandbox.launcher(course.sandbox))
    begin = time.perf_counter()
    station.close()
    _verify(result.passed for result in session.run(cells, course.exercises, options).exercises)
    cold = time.perf_counter() - begin
    best = None
    for _ in range(5):
        begin = time.perf_counter()
        report = session.run(cells, course.exercises, options)
        seconds = time.perf_counter() - begin
        _verify(result.passed for result in report.exercises)
        if best is None or seconds < best[0]:
            best = seconds, report.spent
    seconds, spent = best
    yield Measurement('once per run: start and import of both servers', cold - seconds, 's')
    yield Measurement('one session, warm: all', seconds, 's')
    yield Measurement('  start: two sandboxes, processes', seconds - spent['pytest'], 's')
    yield Measurement('  load: programs into processes', spent['load'], 's')
    yield Measurement('  discovery', spent['discovery'], 's')
    yield Measurement('  tests: all else', spent['pytest'] - spent['load'] - spent['discovery'], 's')


def _verify(marks) -> None:
    if not all(marks):
        raise RuntimeError('a right answer did not get full marks')


class _Peak:
    """The most memory that this process and those that it has started had at a time: what they share counts once."""

    def __enter__(self) -> '_Peak':
        self.bytes = 0
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()
        return self

    def __exit__(self, *_) -> None:
        self._over.set()
        self._thread.join()

    def _watch(self) -> None:
        me = psutil.Process()
        while not self._over.wait(0.25):
            total = 0
            for process in (me, *me.children(recursive=True)):
                try:
                    total += process.memory_full_info().pss
                except (psutil.Error, OSError):
                    pass
            self.bytes = max(self.bytes, total)


def main() -> None:
    """Grade as many submissions as the argument says, one at a time: the program that `_program` times."""
    count = int(sys.argv[1])
    with tempfile.TemporaryDirectory(prefix='course-bench-') as folder:
        _run(_course(Path(folder)), count, Path(folder, 'results'), jobs=1)


if __name__ == '__main__':
    main()
