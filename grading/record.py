"""One learner's result: what `results/<learner>.json` holds, and all reports are made from.

The file's format has a number, SCHEMA. A file of another number is not read: its submission is graded again.
"""

import json
import math
from dataclasses import asdict, dataclass, field
from pathlib import Path

from grading import schemas
from grading.adjustments import Adjustment
from grading.late import Late, is_stamp
from helpers.runner import verdicts
from helpers.runner.results import ExerciseResult

SCHEMA = 2
MAX_BYTES = 64 * 2**20  # of a record: no grader writes so much


@dataclass(frozen=True)
class Attempt:
    """An earlier submission of the learner's. It does not count."""

    source: str  # the submission's file name
    sha256: str
    handed_in: str
    score: float | None = None  # None: it was never graded, or not to the end


@dataclass
class Record:
    """The result of a learner's latest submission."""

    learner: str
    source: str  # the submission's file name
    key: str  # of the submission, the seed, the tests and the grader: the same key, the same result
    sandbox: str
    exercises: list[ExerciseResult]  # as the tests judge them, in the order of the course
    log: list[str] = field(default_factory=list)  # for the instructor
    seed: str = ''  # the run's: `--seed` with it gives the tests the same inputs
    sha256: str = ''  # of what was handed in
    handed_in: str = ''  # ISO 8601, UTC: see grading.submissions
    course: str = ''  # digest of the tests and the grader
    keys: dict[str, str] = field(default_factory=dict)  # as `key`, of each exercise
    ungraded: list[str] = field(default_factory=list)  # exercises that were left out with `--only`
    attempts: list[Attempt] = field(default_factory=list)  # earlier ones, the oldest first
    late: Late | None = None  # None: there is no late policy
    adjustments: list[Adjustment] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)  # about the submission as a whole, for the instructor
    seconds: float = field(default=0.0, compare=False)  # wall time of the grading
    own: str = ''  # the name under which it was handed in; another name that gives the same id is another learner

    @property
    def points(self) -> float:
        """All points there are."""
        return sum(exercise.points for exercise in self.exercises)

    @property
    def marks(self) -> dict[str, float | None]:
        """What counts, by exercise: the tests' score, less the deduction for lateness, then as adjusted by hand."""
        marks: dict[str, float | None] = {}
        for exercise in self.exercises:
            mark = exercise.score
            if mark is not None and self.late is not None:
                mark = self.late.applied(mark)
            for adjustment in self.adjustments:
                if adjustment.exercise == exercise.id:
                    mark = adjustment.applied(mark, exercise.points)
            marks[exercise.id] = mark
        return marks | dict.fromkeys(self.ungraded)

    @property
    def earned(self) -> float | None:
        """The points by the tests alone, before lateness and adjustments."""
        return _total([*(exercise.score for exercise in self.exercises), *(None for _ in self.ungraded)])

    @property
    def score(self) -> float | None:
        """The points that count; None while a grader's fault leaves some unknown, or not all is graded."""
        return _total(list(self.marks.values()))

    @property
    def status(self) -> str:
        """graded, invalid (nothing could be graded), grader_error (to be graded again) or incomplete (`--only`)."""
        marks = self.marks
        kinds = {exercise.verdict for exercise in self.exercises}
        if any(marks[exercise.id] is None for exercise in self.exercises):
            return 'grader_error'
        if self.ungraded:
            return 'incomplete'
        return 'invalid' if kinds == {verdicts.INVALID_SUBMISSION} else 'graded'

    def as_dict(self) -> dict:
        """The record as JSON values; what is derived stands beside what it is derived from."""
        data = {
            'schema': SCHEMA,
            **asdict(self),
            'status': self.status,
            'score': self.score,
            'earned': self.earned,
            'points': self.points,
            'marks': self.marks,
        }
        data['exercises'] = [exercise.as_dict() for exercise in self.exercises]
        return data

    def dumps(self) -> str:
        """The record as JSON text."""
        return json.dumps(self.as_dict(), indent=1, ensure_ascii=False) + '\n'

    @classmethod
    def load(cls, path: Path) -> 'Record | None':
        """Read a record; None if there is none that can be used: it is then graded again, and harms nobody else."""
        try:
            if path.stat().st_size > MAX_BYTES:
                return None
            data = json.loads(
                path.read_text(encoding='utf-8'), parse_constant=_finite, parse_float=_finite, parse_int=_bounded
            )
            schemas.check('result')(data)
            for derived in ('schema', 'status', 'score', 'earned', 'points', 'marks'):
                del data[derived]
            found = cls(
                **{
                    **data,
                    'exercises': [ExerciseResult.from_dict(row) for row in data['exercises']],
                    'attempts': [Attempt(**row) for row in data['attempts']],
                    'late': None if data['late'] is None else Late(**data['late']),
                    'adjustments': [Adjustment(**row) for row in data['adjustments']],
                }
            )
            return found if found.learner == path.stem and found.sound() else None
        except Exception:  # noqa: BLE001 - whatever is wrong with it, it cannot be used
            return None

    def sound(self) -> bool:
        """Whether what is derived from it, and shown, can be made. May raise what a wrong value raises."""
        if any((one.points is None) == (one.delta is None) for one in self.adjustments):
            return False
        return (not self.handed_in or is_stamp(self.handed_in)) and bool(self.status) and (self.score or 0.0) >= 0.0


def _finite(text: str) -> float:
    """A number of a record, if it is one that can be shown."""
    if not math.isfinite(number := float(text)):
        raise ValueError(text)
    return number


def _bounded(text: str) -> int:
    if len(text) > 18:
        raise ValueError(text)
    return int(text)


def _total(marks: list[float | None]) -> float | None:
    known = [mark for mark in marks if mark is not None]
    return round(sum(known), 2) if len(known) == len(marks) else None
