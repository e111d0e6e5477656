"""The results of the cases of one run."""

from __future__ import annotations

import time
import unittest
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from launch_testing.loader import TestRun


class TestResult(unittest.TextTestResult):
    """A result that remembers its cases and how long each took."""

    __test__ = False  # for pytest: this is no class of cases

    def __init__(self, *args: Any, **kwargs: Any):
        super().__init__(*args, **kwargs)
        self.seconds: dict[unittest.TestCase, float] = {}
        self._begin = 0.0

    def startTest(self, test: unittest.TestCase) -> None:
        self._begin = time.monotonic()
        super().startTest(test)

    def stopTest(self, test: unittest.TestCase) -> None:
        super().stopTest(test)
        self.seconds[test] = time.monotonic() - self._begin

    def append(self, other: unittest.TestResult) -> None:
        """Add the cases of another result."""
        self.testsRun += other.testsRun
        for kind in ('failures', 'errors', 'skipped', 'expectedFailures', 'unexpectedSuccesses'):
            getattr(self, kind).extend(getattr(other, kind))
        self.seconds.update(getattr(other, 'seconds', {}))


class FailResult(unittest.TestResult):
    """The result of a run whose cases could not all run: each counts as failed; ``message`` says why."""

    def __init__(self, test_run: TestRun, message: str):
        super().__init__()
        self.message = message
        self.seconds: dict[unittest.TestCase, float] = {}
        self.failures = [(case, message) for case in test_run.all_cases()]
        self.testsRun = len(self.failures)

    def wasSuccessful(self) -> bool:
        return False


class SkipResult(unittest.TestResult):
    """The result of a run that is skipped with all of its cases; ``message`` says why."""

    def __init__(self, test_run: TestRun, skip_reason: str = ''):
        super().__init__()
        self.message = skip_reason
        self.seconds: dict[unittest.TestCase, float] = {}
        self.skipped = [(case, skip_reason) for case in test_run.all_cases()]
        self.testsRun = len(self.skipped)
