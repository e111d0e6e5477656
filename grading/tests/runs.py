"""For tests of runs: works, and a grading that takes no time. `python -m grading.tests.runs FOLDER` kills runs.

It kills a run with SIGKILL at each of its writes, by turns before and after it, and each time starts it again.
"""

import os
import shutil
import signal
import sys
from pathlib import Path

from grading import grading_run, parallel, unit
from grading.submission import Submission
from helpers.runner.results import ExerciseResult
from helpers.tests import small

LEARNERS = ('ada', 'bob', 'eve', 'fay')
SETTINGS = grading_run.Settings(seed='s')
COURSE = grading_run.Course((small.exercise(1), small.exercise(2, points=5)), Path('none'), Path('none'), 'none')


def works(*learners: str) -> list[Submission]:
    """A submission of each."""
    return [
        Submission(
            learner, Path(f'{learner}.ipynb'), {small.NOTEBOOK: learner.encode()}, handed_in='2026-11-01T10:00:00Z'
        )
        for learner in learners or LEARNERS
    ]


def perform(work: unit.Unit, say=lambda test: None) -> unit.Outcome:
    """Full marks for ada, half for others, and what was drawn."""
    name = work.files[small.NOTEBOOK].decode()
    share = 1.0 if name.startswith('ada') else 0.5
    found = []
    for exercise in work.course.exercises:
        if exercise.id in work.exercises:
            say(f'exercises/90_1/hidden::{exercise.id}')
            found.append(
                ExerciseResult(
                    exercise.id,
                    exercise.title,
                    exercise.points,
                    'passed' if share == 1 else 'failed',
                    exercise.points * share,
                    work.seed,
                )
            )
    return unit.Outcome(found, 'none')


def contents(folder: Path) -> dict[str, bytes]:
    """The bytes of all files but the log, by path."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob('*'))
        if path.is_file() and path.name not in ('run.log', '.lock')
    }


def _killed(output: Path, moment: int, before: bool) -> bool:
    """Run in a child that is killed at its `moment`-th write; False if it came to its end."""
    child = os.fork()
    if child == 0:
        replace, count = os.replace, 0

        def counted(*arguments):
            nonlocal count
            count += 1
            if count == moment and before:
                os.kill(os.getpid(), signal.SIGKILL)
            replace(*arguments)
            if count == moment:
                os.kill(os.getpid(), signal.SIGKILL)

        os.replace = counted
        try:
            grading_run.grade(works(), COURSE, output, 2, settings=SETTINGS)
            os._exit(0)
        finally:
            os._exit(1)
    _, status = os.waitpid(child, 0)
    assert status in (0, signal.SIGKILL), f'the run ended with status {status}'
    return status == signal.SIGKILL


def main(folder: Path) -> None:
    """Kill runs at every moment; prints how many moments there were."""
    parallel.units.perform = perform
    os.fsync = lambda descriptor: None  # a killed process needs none
    grading_run.Course.digests = property(lambda course: {exercise.id: 'same' for exercise in course.exercises})
    grading_run.grade(works(), COURSE, folder / 'undisturbed', 2, settings=SETTINGS)
    expected = contents(folder / 'undisturbed')
    moment, killed = 0, True
    while killed:
        moment += 1
        output = folder / f'{moment}'
        killed = _killed(output, moment, before=moment % 2 == 0)
        there = {path.stem for path in (output / 'results').glob('[a-z]*.json')}
        fresh = []
        listener = grading_run.RunListener()
        listener.finished = lambda record, new, changes, fresh=fresh: new and fresh.append(record.learner)
        grading_run.grade(works(), COURSE, output, 2, listener, SETTINGS)
        assert sorted(fresh) == sorted(set(LEARNERS) - there), (moment, fresh, there)
        assert contents(output) == expected, moment
        shutil.rmtree(output)
    print(moment - 1)


if __name__ == '__main__':
    main(Path(sys.argv[1]))
