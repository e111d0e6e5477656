"""Grades submissions into a folder of results; run again, it goes on where it stopped.

The truth is `results/<learner>.json`, written whole or not at all as soon as a submission is graded. Everything else in
the folder is made from these files, at the end of each run.
"""

import hashlib
import logging
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

from grading import sandbox, similarity
from grading.record import Record, write
from grading.reports.output import write_all
from grading.submissions import Submission
from helpers.exercises import manifest
from helpers.exercises.manifest import Exercise
from helpers.exercises.notebooks import InvalidSubmission
from helpers.runner import results, session, verdicts
from helpers.runner.results import ExerciseResult

HIDDEN = Path(__file__).resolve().parent / 'hidden'
_RUNNER = Path(session.__file__).resolve().parent
_EXERCISES = Path(manifest.__file__).resolve().parent


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

    def digest(self) -> str:
        """SHA-256 of all that a mark depends on besides the submission."""
        digest = hashlib.sha256(repr((self.exercises, self.sandbox)).encode())
        for folder in (self.visible, self.hidden, _RUNNER, _EXERCISES):
            for path in sorted(folder.rglob('*')):
                if path.suffix in ('.py', '.xml') and path.is_file():
                    digest.update(f'{path.relative_to(folder)}\0'.encode() + path.read_bytes() + b'\0')
        return digest.hexdigest()


def grade(submissions: list[Submission], course: Course, output: Path, jobs: int = 1,
          say: Callable[[Record, bool], None] = lambda record, fresh: None) -> list[Record]:
    """Grade what has no result in `output` yet, then write the reports and the gradebook.

    :param jobs: how many processes of tests run at a time.
    :param say: is told each record as it is there, and whether it was graded just now.
    """
    output.mkdir(parents=True, exist_ok=True)
    log = _log(output)
    state = course.digest()
    records: dict[str, Record] = {}
    waiting = []
    for submission in submissions:
        key = hashlib.sha256(f'{state}{submission.digest()}'.encode()).hexdigest()
        record = Record.load(_path(output, submission.learner))
        if record is not None and record.key == key and record.status != 'grader_error':
            records[submission.learner] = record
            log.info('%s: unchanged', submission.learner)
            say(record, False)
        else:
            waiting.append((submission, key))
    log.info('%d of %d submissions to grade, sandbox %s', len(waiting), len(submissions), course.sandbox)
    processes = max(1, jobs // max(1, len(waiting)))
    pool = ThreadPoolExecutor(max(1, jobs))
    try:
        graded = [pool.submit(_grade_one, submission, key, course, output, processes) for submission, key in waiting]
        for future in as_completed(graded):
            record = future.result()
            records[record.learner] = record
            log.info('%s: %s, %s of %g points', record.learner, record.status, record.score, record.points)
            for line in record.log:
                log.warning('%s: %s', record.learner, line)
            say(record, True)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)  # an interrupted run does not wait for the rest
    ordered = [records[learner] for learner in sorted(records)]
    finish(ordered, course, output, submissions)
    log.info('done: %d records', len(ordered))
    _close(log)
    return ordered


def finish(records: Iterable[Record], course: Course, output: Path, submissions: Iterable[Submission] = ()) -> None:
    """Write all that is made from the records. `submissions` are compared with each other."""
    answers = {submission.learner: similarity.cells_of(submission.files, course.exercises)
               for submission in submissions}
    write_all(records, course.exercises, output, answers)


def judge(submission: Submission, course: Course, processes: int = 1) -> session.Report:
    """Run all tests, visible and hidden, of one submission."""
    options = session.Options(hidden=course.hidden, visible=course.visible, processes=processes,
                              launcher=sandbox.launcher(course.sandbox), test_timeout=course.test_timeout)
    judged: dict[str, ExerciseResult] = {}
    log = []
    used = course.sandbox
    for notebook in dict.fromkeys(exercise.notebook for exercise in course.exercises):
        mine = [exercise for exercise in course.exercises if exercise.notebook == notebook]
        try:
            cells = submission.cells(notebook, mine)
        except InvalidSubmission as problem:
            judged |= {exercise.id: results.without_tests(exercise, verdicts.INVALID_SUBMISSION, str(problem))
                       for exercise in mine}
            continue
        if cells is None:
            judged |= {exercise.id: results.without_tests(exercise, results.NOT_ATTEMPTED,
                                                          f'{notebook} was not handed in.') for exercise in mine}
            continue
        report = session.run(cells, mine, options)
        used = report.sandbox or used
        log += report.log
        judged |= {result.id: result for result in report.exercises}
    return session.Report([judged[exercise.id] for exercise in course.exercises], used, log)


def _grade_one(submission: Submission, key: str, course: Course, output: Path, processes: int) -> Record:
    report = judge(submission, course, processes)
    record = Record(submission.learner, submission.source.name, key, report.sandbox, report.exercises, report.log)
    write(_path(output, submission.learner), record.dumps())
    return record


def _path(output: Path, learner: str) -> Path:
    return output / 'results' / f'{learner}.json'


def _log(output: Path) -> logging.Logger:
    log = logging.Logger('grade', logging.INFO)
    handler = logging.FileHandler(output / 'run.log', encoding='utf-8')
    handler.setFormatter(logging.Formatter('%(asctime)s %(levelname)s %(message)s'))
    log.addHandler(handler)
    return log


def _close(log: logging.Logger) -> None:
    for handler in log.handlers:
        handler.close()
