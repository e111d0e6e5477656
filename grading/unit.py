"""The unit of work: one submission and the exercises of it that are to be graded. It needs nothing but itself.

A unit may be done in a thread of the grader or on another machine of a cluster. What comes back is data.
"""

import socket
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path

from grading import reference, sandbox
from grading.course import Course
from grading.submission import Submission
from helpers import paths
from helpers.runner import session, verdicts
from helpers.runner.results import ExerciseResult


class Mismatch(Exception):
    """The course is not, or not any more, what the run began with; the message names the machine."""


@dataclass(frozen=True)
class Unit:
    """What is to be done, with all that is needed for it."""

    files: dict[str, bytes]
    problem: str  # what makes the submission unreadable
    unusable: dict[str, str]  # see `Submission`
    course: Course  # packed
    digest: str  # of the course, on the grader's machine
    exercises: tuple[str, ...]
    seed: str
    processes: int = 1


@dataclass
class Outcome:
    """What became of a unit."""

    exercises: list[ExerciseResult]
    sandbox: str = ''
    log: list[str] = field(default_factory=list)  # for the instructor
    seconds: float = 0.0


def perform(unit: Unit, say: Callable[[str], None] = lambda test: None) -> Outcome:
    """Grade. `say` is told each test that has finished.

    :raises Mismatch: this machine's course is not the grader's.
    """
    course = unit.course.unpacked()
    if course.digest != unit.digest:
        raise Mismatch(
            f'the course at {paths.ROOT} on {socket.gethostname()} is not the one that this run began with: '
            'tests, grader, Python and sandbox must be the same; what is graded is kept'
        )
    began = time.monotonic()
    report = judge(
        Submission('', Path(), unit.files, unit.problem, unit.unusable),
        course,
        unit.processes,
        only=unit.exercises,
        seed=unit.seed,
        say=say,
    )
    return Outcome(report.exercises, report.sandbox, report.log, round(time.monotonic() - began, 3))


def fault(unit: Unit, text: str) -> Outcome:
    """The outcome of a unit that could not be done: no mark, and no zero."""
    open_ones = [
        ExerciseResult(exercise.id, exercise.title, exercise.points, verdicts.GRADER_ERROR, None)
        for exercise in unit.course.exercises
        if exercise.id in unit.exercises
    ]
    return Outcome(open_ones, unit.course.sandbox, [text])


def judge(
    submission: Submission,
    course: Course,
    processes: int = 1,
    *,
    only: Iterable[str] | None = None,
    seed: str = '',
    say: Callable[[str], None] = lambda test: None,
) -> session.SessionReport:
    """Run all tests, visible and hidden, of one submission, or of the exercises `only`."""
    options = session.Options(
        hidden=course.hidden,
        visible=course.visible,
        processes=processes,
        seed=seed,
        launcher=sandbox.launcher(course.sandbox),
        test_timeout=course.test_timeout,
        reference=reference.program,
    )
    wanted = [exercise for exercise in course.exercises if only is None or exercise.id in only]
    found = submission.programs(wanted, course.exercises)
    report = session.judge(found.programs, found.without, wanted, options, say)
    return replace(report, sandbox=report.sandbox or course.sandbox)
