"""Results of tests and exercises, and the score: pure data and pure functions.

Scores fail closed: only an explicit pass counts. An error of the grader's leaves the score unknown (None), so
that it is never mistaken for a learner's zero.
"""

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace

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
    rules: list[str] = field(default_factory=list)  # the rules of the card that the test looks at
    rule: str = ''  # the one that is broken, where the test knows it
    so_far: list[str] = field(default_factory=list)  # rules that nothing had broken before the test failed
    hint: bool = False  # whether the rest of `expected`, a general hint, fits beside the message
    given: bool = False  # whether the cell passes it as it was given: it counts only beside another one that passes

    @property
    def passed(self) -> bool:
        return self.verdict == verdicts.PASSED


KEPT, BROKEN, NOT_LOOKED_AT = 'kept', 'broken', 'not_looked_at'
AS_GIVEN = (
    'What passed was right before you began. It counts as soon as something passes that was not: see the other tests.'
)
SO_FAR = 'nothing wrong so far'  # why a rule is not looked at: only a part of its test has run, and found no fault


@dataclass
class RuleResult:
    """What the tests say of one rule of the card."""

    name: str
    text: str  # the sentence of the card
    state: str  # KEPT, BROKEN or NOT_LOOKED_AT
    why: str = ''  # it is not looked at


@dataclass
class ExerciseResult:
    """One exercise's outcome. `verdict`: the worst of its tests', or not_attempted."""

    id: str
    title: str
    points: float
    verdict: str
    score: float | None  # None: unknown, because of an error of the grader's
    message: str = ''  # about the exercise as a whole: not attempted, invalid
    tests: list[TestResult] = field(default_factory=list)
    rules: list[RuleResult] = field(default_factory=list)  # in the order of the card

    @property
    def passed(self) -> bool:
        return self.verdict == verdicts.PASSED

    def count_rules(self, state: str) -> int:
        """How many rules of the card are in this state."""
        return sum(rule.state == state for rule in self.rules)

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
        return cls(
            **{
                **data,
                'tests': [TestResult(**test) for test in data['tests']],
                'rules': [RuleResult(**rule) for rule in data.get('rules', ())],
            }
        )


# From the worst to the best: what an exercise with several verdicts is called.
_ORDER = (
    verdicts.GRADER_ERROR,
    verdicts.INVALID_SUBMISSION,
    verdicts.TIMEOUT,
    verdicts.LEARNER_CRASHED,
    verdicts.FAILED,
    verdicts.PASSED,
)


def scored(exercise: Exercise, tests: list[TestResult], unseen: Mapping[str, str] | None = None) -> ExerciseResult:
    """Score an exercise: points times passed weight over total weight, rounded to two decimals.

    Who passes only what the cell passes as it was given has done nothing, and gets nothing.

    `unseen`: why no visible test looks at a rule, by its name.
    """

    def result(verdict: str, score: float | None) -> ExerciseResult:
        return ExerciseResult(
            exercise.id,
            exercise.title,
            exercise.points,
            verdict,
            score,
            tests=tests,
            rules=_rules(exercise, tests, unseen or {}),
        )

    names = [test.test for test in tests]
    weights = [test.weight for test in tests]
    sound = (
        tests
        and len(set(names)) == len(names)
        and all(math.isfinite(weight) and weight > 0 for weight in weights)
        and all(test.exercise == exercise.id and test.verdict in verdicts.VERDICTS for test in tests)
    )
    if not sound or any(test.verdict == verdicts.GRADER_ERROR for test in tests):
        return result(verdicts.GRADER_ERROR, None)
    verdict = next(kind for kind in _ORDER if any(test.verdict == kind for test in tests))
    passed = [test for test in tests if test.passed]
    if passed and all(test.given for test in passed):
        return replace(result(verdict, 0.0), message=AS_GIVEN)
    return result(verdict, round(exercise.points * sum(test.weight for test in passed) / sum(weights), 2))


def _rules(exercise: Exercise, tests: list[TestResult], unseen: Mapping[str, str]) -> list[RuleResult]:
    """What the tests say of each rule of the card."""
    broken = {test.rule for test in tests if not test.passed}
    kept = {rule for test in tests if test.passed for rule in test.rules}
    found = []
    for rule in exercise.rules:
        looking = [test for test in tests if rule.name in test.rules]
        if rule.name in broken:
            found.append(RuleResult(rule.name, rule.text, BROKEN))
        elif rule.name in kept:
            found.append(RuleResult(rule.name, rule.text, KEPT))
        else:
            first = next((test.rule for test in looking if test.rule), '')
            why = (
                SO_FAR
                if any(rule.name in test.so_far for test in looking)
                else f'what breaks “{first}” hides it'
                if first
                else 'the program did not come so far'
                if looking
                else unseen.get(rule.name, 'no test has run')
            )
            found.append(RuleResult(rule.name, rule.text, NOT_LOOKED_AT, why))
    return found


def without_tests(exercise: Exercise, verdict: str, message: str) -> ExerciseResult:
    """The result of an exercise for which no test runs: not attempted, or invalid."""
    return ExerciseResult(exercise.id, exercise.title, exercise.points, verdict, 0.0, message)
