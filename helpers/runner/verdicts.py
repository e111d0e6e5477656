"""The six verdicts, and the exceptions that carry one from the learner's side to a test.

A test never raises these itself: `expect` and the `learner` fixture do. Their text is written for the
learner; any other exception in a test is the grader's own fault and its text stays with the instructor.
"""

PASSED = 'passed'
FAILED = 'failed'
TIMEOUT = 'timeout'
LEARNER_CRASHED = 'learner_crashed'
INVALID_SUBMISSION = 'invalid_submission'
GRADER_ERROR = 'grader_error'

VERDICTS = (PASSED, FAILED, TIMEOUT, LEARNER_CRASHED, INVALID_SUBMISSION, GRADER_ERROR)


class LearnerFault(Exception):
    """The learner's program did not do what was asked; `message` is for the learner."""

    verdict = FAILED

    def __init__(self, message: str, details: str = ''):
        """`details` is longer text to fold away: a traceback through the learner's own lines."""
        super().__init__(message)
        self.message = message
        self.details = details


class ExpectationFailed(LearnerFault):
    """An `expect` in a test was not met."""


class WiringFault(LearnerFault):
    """A type or QoS setting keeps the learner's endpoint and the test's from being connected."""


class LearnerCrashed(LearnerFault):
    """The learner's code raised an exception, or its process ended."""

    verdict = LEARNER_CRASHED


class LearnerTimeout(LearnerFault):
    """The learner's code did not return in time."""

    verdict = TIMEOUT


class InvalidProgram(LearnerFault):
    """What the exercise asks for is not there."""

    verdict = INVALID_SUBMISSION


def expect(condition, message: str) -> None:
    """Fail the running test with `message` unless `condition` is true.

    The message is for the learner: name what their program did and the misconception it looks like.
    """
    if not condition:
        raise ExpectationFailed(message)
