"""Grades submissions into a folder of results; run again, it goes on where it stopped.

The truth is `results/<learner>.json`, written whole or not at all as soon as a submission is graded. Everything else in
the folder is made from these files, at the end of each run.

    submissions  finds who handed in what        plan       what is to be graded, and what is kept
    course       what it is graded against       unit       the work, wherever it is done
    folder       lock, seed, records, log        executors  threads, or a Dask cluster
    late, adjustments, anonymous                 what else a mark depends on
"""

import contextlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from grading import adjustments as manual
from grading import anonymous, parallel, plan, sandbox, similarity
from grading.adjustments import Adjustment
from grading.choice import Choice
from grading.course import HIDDEN, Course
from grading.folder import Folder
from grading.late import Policy, PolicyError
from grading.record import Record
from grading.reports.output import write_all
from grading.submission import Submission, apart, identity
from grading.unit import Outcome, judge

__all__ = ['HIDDEN', 'Course', 'RunListener', 'Settings', 'finish', 'grade', 'judge']


@dataclass(frozen=True)
class Settings:
    """How a run goes, besides what it grades."""

    seed: str = ''  # for the inputs that tests draw; the folder's own if empty
    only: tuple[str, ...] = ()  # `learner`, `learner/exercise`: see grading.choice
    regrade: bool = False  # grade also what has a result already
    late: Policy | None = None
    adjustments: tuple[Adjustment, ...] = ()
    anonymous: bool = False
    chapters: tuple[int, ...] = ()  # that the course is limited to; none: the whole course
    cluster: str = ''  # the address of a Dask scheduler; threads of this process if empty


class RunListener:
    """Is told how a run goes. `tested` may come from any thread."""

    def begun(self, todo: int, all_of_them: int) -> None:
        """So many submissions of all are to be graded."""

    def tested(self, learner: str, test: str) -> None:
        """A test has finished."""

    def finished(self, record: Record, fresh: bool, changes: list[str]) -> None:
        """A record is there, `fresh` if it was graded just now. `changes`: marks that differ from the last run's."""


def grade(
    submissions: list[Submission],
    course: Course,
    output: Path,
    jobs: int = 1,
    listener: RunListener | None = None,
    settings: Settings = Settings(),
) -> list[Record]:
    """Grade what has no result in `output` yet, then write the reports and the gradebook.

    :param jobs: how many processes of tests run at a time on this machine.
    :return: the records of all learners that the folder knows, sorted.
    :raises FolderError, ChoiceError, AdjustmentError, PolicyError, AnonymousError, ClusterError, Mismatch: the run
        cannot be done as asked; what is graded already is kept.
    """
    with (
        contextlib.closing(parallel.Cluster(settings.cluster))
        if settings.cluster
        else contextlib.nullcontext() as cluster,
        Folder(output).open() as log,
    ):
        course = replace(course)  # whose digests are those of now
        run = _Run(submissions, course, Folder(output), log, listener or RunListener(), settings)
        run.grade(cluster or parallel.Local(max(1, jobs)), jobs)
        finish(run.everybody(), course, output, run.files)
        log.info('done: %d records', len(run.records))
        return run.everybody()


def finish(
    records: Iterable[Record], course: Course, output: Path, files: Mapping[str, Mapping[str, bytes]] | None = None
) -> None:
    """Write all that is made from the records. `files`: by learner, the notebooks, which are compared."""
    write_all(
        records,
        course.exercises,
        output,
        {learner: similarity.of_submission(own, course.exercises) for learner, own in (files or {}).items()},
    )


class _Run:
    """One run, while its folder is held."""

    def __init__(self, submissions, course: Course, folder: Folder, log, listener: RunListener, settings: Settings):
        self.course, self.folder, self.log, self.listener, self.settings = course, folder, log, listener, settings
        self.seed = folder.settle(settings.seed, settings.anonymous, settings.chapters)
        self.records = folder.records()
        submissions = self._told_apart(submissions)
        self.ids = self._ids(submissions)
        known = {**{record: record for record in self.records if not settings.anonymous}, **self.ids}
        exercises = [exercise.id for exercise in course.exercises]
        self.choice = Choice.parse(settings.only, known, exercises)
        manual.check(settings.adjustments, known)
        unknown = settings.late.learners - set(known) if settings.late else ()
        if unknown:
            raise PolicyError(f'the late policy names the unknown learner {min(unknown)!r}')
        self.names = {identity: learner for learner, identity in known.items()}
        self.plans = {}
        for submission in submissions:
            identity = self.ids[submission.learner]
            self.plans[identity] = plan.make(
                identity,
                submission,
                course,
                self.seed,
                self.records.get(identity),
                self._chosen_of(submission.learner),
                settings.regrade,
            )
            self.plans[identity].own = self._own(submission)
        self.files = {self.ids[submission.learner]: submission.files for submission in submissions}

    def _chosen_of(self, learner: str) -> Callable[[str], bool]:
        return lambda exercise: (learner, exercise) in self.choice

    def _ids(self, submissions) -> dict[str, str]:
        """By learner: the id, or the pseudonym."""
        ids = {submission.learner: submission.learner for submission in submissions}
        return anonymous.pseudonyms(ids, self.folder.path) if self.settings.anonymous else ids

    def _own(self, submission: Submission) -> str:
        return (
            anonymous.sealed(f'name {submission.own}', self.folder.path)
            if self.settings.anonymous
            else (submission.own)
        )

    def _record(self, learner: str) -> Record | None:
        return self.records.get(anonymous.sealed(learner, self.folder.path) if self.settings.anonymous else learner)

    def _told_apart(self, submissions: list[Submission]) -> list[Submission]:
        """Submissions of which none takes the place of another learner's record.

        An id that a zip says, or that two names give, is not enough for that: the record knows under which name it was
        handed in. If that one had the id from its zip only, the name of a file or folder comes before it.
        """
        if self.settings.anonymous:
            self._ids(submissions)  # makes the salt
        taken, told = {submission.learner for submission in submissions}, []
        for submission in submissions:
            own, record = self._own(submission), self._record(submission.learner)
            plain, other = identity(submission.own), apart(submission.own)
            earlier = self._record(plain)
            if record is not None and submission.learner == plain and self._lent(record):
                note = (
                    f'the earlier record of {plain} is of {record.own}, which only had this id in its zip: it is '
                    f"{self._give_back(record)}'s now"
                )
                submission = replace(submission, notes=[*submission.notes, note])
            elif record is None and submission.learner == other and earlier is not None and earlier.own == own:
                submission = replace(submission, learner=plain)  # it had the id before somebody else gave the same one
            elif record is not None and record.own not in ('', own):
                free = plain not in taken and (earlier is None or earlier.own in ('', own))
                learner = plain if free else other
                note = (
                    f'{submission.learner} is the id of a learner whose work is on record under another name than '
                    f"{submission.own}: taken as {learner}'s"
                )
                submission = replace(submission, learner=learner, notes=[*submission.notes, note])
            taken.add(submission.learner)
            told.append(submission)
        return list(self._one_each(told))

    def _one_each(self, submissions: list[Submission]) -> Iterator[Submission]:
        """No submission is lost because two have one id in the end: the second one gets an id of its own."""
        used: set[str] = set()
        for submission in sorted(submissions, key=lambda one: one.learner != identity(one.own)):
            learner, own = submission.learner, submission.own
            while learner in used:
                learner, own = apart(own), f'{own} '
            if learner != submission.learner:
                note = f"{submission.learner} is the id of another submission: taken as {learner}'s"
                submission = replace(submission, learner=learner, notes=[*submission.notes, note])
            used.add(learner)
            yield submission

    def _lent(self, record: Record) -> bool:
        """Whether a record has its id from a zip, and not from the name under which it was handed in.

        With `--anonymous` nobody knows: that name is sealed.
        """
        known = bool(record.own) and not self.settings.anonymous
        return known and record.learner not in (identity(record.own), apart(record.own))

    def _give_back(self, record: Record) -> str:
        """Let a record have the id of the name under which it was handed in; returns that."""
        del self.records[record.learner]
        there = self.records.get(identity(record.own))
        learner = identity(record.own) if there is None or there.own in ('', record.own) else apart(record.own)
        self.records.setdefault(learner, replace(record, learner=learner))
        return learner

    def everybody(self) -> list[Record]:
        """All records, sorted."""
        return [self.records[learner] for learner in sorted(self.records)]

    def grade(self, executor: parallel.Local | parallel.Cluster, jobs: int) -> None:
        """Grade what is to be graded, and bring the other records up to date."""
        todo = {learner: made for learner, made in self.plans.items() if made.todo}
        self.log.info(
            '%d of %d submissions to grade, sandbox %s, seed %s%s',
            len(todo),
            len(self.plans),
            self.course.sandbox,
            self.seed,
            f', on {self.settings.cluster}' if self.settings.cluster else f', {jobs} at a time',
        )
        if self.course.sandbox == 'none':
            self.log.warning(sandbox.WARNING)
        self.listener.begun(len(todo), len(self.plans))
        for learner, record in list(self.records.items()):
            if learner not in self.plans:  # not given this time
                self._keep(self._judged(record), fresh=False)
        for made in self.plans.values():
            if not made.todo and made.kept:
                self._keep(self._made(made, Outcome([])), fresh=False)
            elif not made.todo and made.previous is not None:  # `--only` leaves another submission for later
                self._keep(self._judged(made.previous), fresh=False)
        processes = max(1, executor.jobs // max(1, len(todo)))
        work = {learner: made.unit(self.course, processes) for learner, made in todo.items()}
        if self.settings.anonymous:
            work = {learner: anonymous.without_names(one) for learner, one in work.items()}
        try:
            for learner, outcome in parallel.perform(work, executor, self.listener.tested):
                self._keep(self._made(todo[learner], outcome), fresh=True)
        finally:
            if isinstance(executor, parallel.Local):
                executor.close()

    def _made(self, made: plan.Plan, outcome: Outcome) -> Record:
        record = plan.record(made, self.course, outcome, self._source)
        if self.settings.anonymous and record.notes:  # they name files and learners
            record = replace(record, notes=['there is a note, which is shown without --anonymous only'])
        return self._judged(record)

    def _judged(self, record: Record) -> Record:
        """The record with what the late policy and the adjustments say."""
        learner, late = self.names.get(record.learner, record.learner), self.settings.late
        mine = [replace(one, learner=record.learner) for one in self.settings.adjustments if one.learner == learner]
        return replace(record, adjustments=mine, late=late.judge(learner, record.handed_in) if late else None)

    def _source(self, name: str) -> str:
        """A file's name as it may be shown: it may hold the learner's."""
        return Path(name).suffix or 'folder' if self.settings.anonymous else name

    def _keep(self, record: Record, fresh: bool) -> None:
        before = self.records.get(record.learner)
        self.records[record.learner] = record
        self.folder.write(record)
        changes = plan.changes(before, record)
        if fresh:
            self.log.info('%s: %s, %s of %g points', record.learner, record.status, record.score, record.points)
            for line in [*record.notes, *record.log]:
                self.log.warning('%s: %s', record.learner, line)
        if changes:
            reasons = self.plans[record.learner].why if fresh else ['late policy or adjustments']
            self.log.info('%s: marks changed (%s): %s', record.learner, ', '.join(reasons), '; '.join(changes))
        elif fresh and self.plans[record.learner].why:
            self.log.info('%s: no mark changed (%s)', record.learner, ', '.join(self.plans[record.learner].why))
        if record.learner in self.plans:
            self.listener.finished(record, fresh, changes)
