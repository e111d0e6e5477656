"""The six verdicts, and the exceptions that carry one from the learner's side to a test.

A test never raises these itself: `expect` and the `learner` fixture do. Their text is written for the learner, and they
name the rule of the exercise's card that is broken; any other exception in a test is the grader's own fault and its
text stays with the instructor.
"""

from collections.abc import Iterator
from contextlib import contextmanager

PASSED = 'passed'
FAILED = 'failed'
TIMEOUT = 'timeout'
LEARNER_CRASHED = 'learner_crashed'
INVALID_SUBMISSION = 'invalid_submission'
GRADER_ERROR = 'grader_error'

met: set[str] = set()  # rules of which the running test has found an expectation met

VERDICTS = (PASSED, FAILED, TIMEOUT, LEARNER_CRASHED, INVALID_SUBMISSION, GRADER_ERROR)


class LearnerError(Exception):
    """The learner's program did not do what was asked; `message` is for the learner."""

    verdict = FAILED
    rule = ''  # the rule of the card that is broken; '' if the test does not say
    hint = False  # whether the test's general hint (the rest of its docstring) fits beside the message

    def __init__(self, message: str, details: str = ''):
        """`details` is longer text to fold away: a traceback through the learner's own lines."""
        super().__init__(message)
        self.message = message
        self.details = details


class ExpectationFailed(LearnerError):
    """An `expect` in a test was not met."""


class WiringError(LearnerError):
    """A type, a QoS setting or a namespace keeps the learner's endpoint and the test's from being connected."""

    def __init__(self, message: str, kind: str):
        """`kind`: 'type', 'qos' or 'namespace'."""
        super().__init__(message)
        self.kind = kind


class LearnerCrashed(LearnerError):
    """The learner's code raised an exception, or its process ended."""

    verdict = LEARNER_CRASHED


class LearnerTimeout(LearnerError):
    """The learner's code did not return in time."""

    verdict = TIMEOUT


class Unheard(LearnerTimeout):
    """The learner's program was not heard, or heard nothing, or all of it took too long.

    That may also be the machine: the test runs once more, and then the verdict stands. What a program says of itself,
    or does not say, never leaves a mark open.
    """


class InvalidProgram(LearnerError):
    """What the exercise asks for is not there."""

    verdict = INVALID_SUBMISSION


def expect(condition, message: str, rule: str = '', *, hint: bool = False) -> None:
    """Fail the running test with `message` unless `condition` is true.

    The message is for the learner: name what their program did and the misconception it looks like. `rule` is the rule
    of the card that is broken then; it may be left out in a test that looks at one rule only. `hint`: the message only
    says what was seen, so the general hint of the test's docstring is shown beside it.
    """
    if not condition:
        raise broken(message, rule, hint=hint)
    met.add(rule)


def broken(message: str, rule: str = '', *, hint: bool = False) -> ExpectationFailed:
    """The exception that `expect` raises, for a test that finds out in another way that a rule is broken."""
    error = ExpectationFailed(message)
    error.rule, error.hint = rule, hint
    return error


@contextmanager
def about(rule: str) -> Iterator[None]:
    """Within the block, what the learner's program does wrong breaks `rule`, unless an `expect` names another one.

    For what the `learner` fixture itself finds out: a crash, a wait that does not end, endpoints that do not fit.
    """
    try:
        yield
    except LearnerError as error:
        error.rule = error.rule or rule
        raise


@contextmanager
def waiting(rule: str) -> Iterator[None]:
    """Within the block, a wait of the learner's program that does not end breaks `rule`.

    For rules that forbid to wait: a crash would say that the program has waited, which it has not.
    """
    try:
        yield
    except LearnerTimeout as error:
        error.rule = error.rule or rule
        raise
