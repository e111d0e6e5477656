"""Results of tests and exercises, and the score: pure data and pure functions.

Scores fail closed: only an explicit pass counts. A grader's fault leaves the score unknown (None), so that it is never
mistaken for a learner's zero.
"""
import math
from dataclasses import asdict, dataclass, field

from helpers.exercises.manifest import Exercise
from helpers.runner import verdicts

NOT_ATTEMPTED = 'not_attempted'


@dataclass
class TestResult:
    """One test's outcome."""

    __test__ = False

    test: str
    exercise: str
    hidden: bool
    weight: float
    verdict: str
    expected: str = ''  # the test's docstring: what the learner reads
    message: str = ''  # what happened, for the learner
    details: str = ''  # a traceback through the learner's own lines
    output: str = ''  # what their program printed
    fault: str = ''  # the grader's own traceback: for the instructor only
    seconds: float = field(default=0.0, compare=False)  # wall time of its last run, which says nothing about the mark

    @property
    def passed(self) -> bool:
        return self.verdict == verdicts.PASSED


@dataclass
class ExerciseResult:
    """One exercise's outcome. `verdict`: the worst of its tests', or not_attempted."""

    id: str
    title: str
    points: float
    verdict: str
    score: float | None  # None: unknown, because of a grader's fault
    message: str = ''  # about the exercise as a whole: not attempted, invalid
    tests: list[TestResult] = field(default_factory=list)

    @property
    def passed(self) -> bool:
        return self.verdict == verdicts.PASSED

    def count(self, hidden: bool) -> tuple[int, int]:
        """(passed tests, all tests) of the hidden or of the visible ones."""
        mine = [test for test in self.tests if test.hidden is hidden]
        return sum(test.passed for test in mine), len(mine)

    def as_dict(self) -> dict:
        """The result as JSON takes it; `from_dict` reads it again."""
        return asdict(self)

    @classmethod
    def from_dict(cls, data: dict) -> 'ExerciseResult':
        """The result that `as_dict` has written. Raises KeyError or TypeError if fields are missing, or unknown."""
        return cls(**{**data, 'tests': [TestResult(**test) for test in data['tests']]})


# From the worst to the best: what an exercise with several verdicts is called.
_ORDER = (verdicts.GRADER_ERROR, verdicts.INVALID_SUBMISSION, verdicts.TIMEOUT, verdicts.LEARNER_CRASHED,
          verdicts.FAILED, verdicts.PASSED)


def judge(exercise: Exercise, tests: list[TestResult]) -> ExerciseResult:
    """Score an exercise: points times passed weight over total weight, rounded to two decimals."""
    def result(verdict: str, score: float | None) -> ExerciseResult:
        return ExerciseResult(exercise.id, exercise.title, exercise.points, verdict, score, tests=tests)

    names = [test.test for test in tests]
    weights = [test.weight for test in tests]
    sound = (tests and len(set(names)) == len(names)
             and all(math.isfinite(weight) and weight > 0 for weight in weights)
             and all(test.exercise == exercise.id and test.verdict in verdicts.VERDICTS for test in tests))
    if not sound or any(test.verdict == verdicts.GRADER_ERROR for test in tests):
        return result(verdicts.GRADER_ERROR, None)
    verdict = next(kind for kind in _ORDER if any(test.verdict == kind for test in tests))
    share = sum(test.weight for test in tests if test.passed) / sum(weights)
    return result(verdict, round(exercise.points * share, 2))


def without_tests(exercise: Exercise, verdict: str, message: str) -> ExerciseResult:
    """The result of an exercise for which no test runs: not attempted, or invalid."""
    return ExerciseResult(exercise.id, exercise.title, exercise.points, verdict, 0.0, message)
