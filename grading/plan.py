"""What of a submission is to be graded, what is kept of an earlier run, and what both make together. Pure functions."""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass, field, replace

from grading.course import Course
from grading.record import Attempt, Record
from grading.submission import Submission
from grading.unit import Outcome, Unit
from helpers.exercises.manifest import Exercise
from helpers.runner import seeds, verdicts
from helpers.runner.results import ExerciseResult


@dataclass
class Plan:
    """One submission: what is kept, and the exercises that are graded now."""

    learner: str  # the id, or the pseudonym
    submission: Submission
    seed: str  # the run's
    keys: dict[str, str]  # by exercise
    kept: dict[str, ExerciseResult]
    todo: list[str]
    previous: Record | None = None
    why: list[str] = field(default_factory=list)  # it is graded again, or not at all
    own: str = ''  # the name under which it was handed in, or its pseudonym

    def unit(self, course: Course, processes: int) -> Unit:
        """The work."""
        return Unit(
            self.submission.files,
            self.submission.problem,
            self.submission.unusable,
            course.packed(),
            course.digest,
            tuple(self.todo),
            seeds.derive(self.seed, self.submission.digest()),
            processes,
        )


def make(
    learner: str,
    submission: Submission,
    course: Course,
    seed: str,
    previous: Record | None,
    chosen: Callable[[str], bool],
    regrade: bool,
) -> Plan:
    """Compare a submission with its record, if there is one.

    A result is kept while submission, seed, tests and grader are the same, and it is not the grader's fault. What is
    not chosen is kept too when the tests have changed, but never from another submission.
    """
    sha256 = submission.digest()
    keys = {identity: _hash(digest, seed, sha256) for identity, digest in course.digests.items()}
    plan = Plan(learner, submission, seed, keys, {}, [], previous)
    kept = previous if previous is not None and previous.sha256 == sha256 else None  # of the same submission
    old = {result.id: result for result in kept.exercises} if kept else {}
    old_keys = kept.keys if kept else {}
    for exercise in course.exercises:
        result = old.get(exercise.id)
        valid = (
            result is not None
            and result.verdict != verdicts.GRADER_ERROR
            and old_keys.get(exercise.id) == keys[exercise.id]
        )
        if chosen(exercise.id) and (regrade or not valid):
            plan.todo.append(exercise.id)
        elif result is not None:
            plan.kept[exercise.id] = result
            if not valid:
                plan.keys[exercise.id] = old_keys.get(exercise.id, '')
    plan.why = _why(plan, course, old, kept is not None, regrade)
    return plan


def _why(plan: Plan, course: Course, old: dict[str, ExerciseResult], same: bool, regrade: bool) -> list[str]:
    if plan.previous is None or not plan.todo:
        return []
    if not same:
        return ['another submission']
    if regrade:
        return ['asked for']
    reasons = []
    if any(identity in old and old[identity].verdict == verdicts.GRADER_ERROR for identity in plan.todo):
        reasons.append('after a fault of the grader')
    if plan.previous.seed != plan.seed:
        reasons.append('another seed')
    elif any(identity in old and old[identity].verdict != verdicts.GRADER_ERROR for identity in plan.todo):
        reasons.append('the tests or the grader have changed')
    return reasons


def record(plan: Plan, course: Course, outcome: Outcome, source: Callable[[str], str]) -> Record:
    """The record of what was kept and what was graded. `source` makes a file name fit to be shown."""
    results = plan.kept | {result.id: result for result in outcome.exercises}
    submission, previous = plan.submission, plan.previous
    ordered = [exercise.id for exercise in course.exercises]
    keys = {identity: plan.keys[identity] for identity in ordered if identity in results}
    kept = None if plan.todo else previous  # nothing was graded now
    return Record(
        learner=plan.learner,
        source=source(submission.source.name),
        key=_hash(*keys.values()),
        sandbox=kept.sandbox if kept else outcome.sandbox,
        exercises=[results[identity] for identity in ordered if identity in results],
        log=kept.log if kept else outcome.log,
        seed=kept.seed if kept else plan.seed,
        sha256=submission.digest(),
        handed_in=submission.handed_in,
        course=kept.course if kept else course.digest,
        keys=keys,
        ungraded=[identity for identity in ordered if identity not in results],
        attempts=_attempts(plan, source),
        notes=list(submission.notes),
        seconds=kept.seconds if kept else outcome.seconds,
        own=plan.own,
    )


def _attempts(plan: Plan, source: Callable[[str], str]) -> list[Attempt]:
    """The earlier submissions: those that were found now, and those that earlier runs knew."""
    sha256 = plan.submission.digest()
    found = {one.sha256: replace(one, source=source(one.source)) for one in plan.submission.earlier}
    if plan.previous is not None:
        before = plan.previous
        for one in [*before.attempts, Attempt(before.source, before.sha256, before.handed_in, before.score)]:
            if one.score is not None or one.sha256 not in found:
                found[one.sha256] = one
    found.pop(sha256, None)
    return sorted(found.values(), key=lambda one: (one.handed_in, one.sha256))


def changes(before: Record | None, after: Record) -> list[str]:
    """Which marks of a learner differ from those in an earlier record: `3.2: 5 → 10`."""
    if before is None:
        return []
    old, new = before.marks, after.marks
    return [
        f'{identity}: {_mark(old.get(identity))} → {_mark(new.get(identity))}'
        for identity in dict.fromkeys([*new, *old])
        if old.get(identity) != new.get(identity)
    ]


def _mark(mark: float | None) -> str:
    return 'open' if mark is None else f'{mark:g}'


def _hash(*texts: str) -> str:
    return hashlib.sha256('\0'.join(texts).encode()).hexdigest()


def points(exercises: tuple[Exercise, ...]) -> dict[str, float]:
    """What each exercise is worth."""
    return {exercise.id: exercise.points for exercise in exercises}
