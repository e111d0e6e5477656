"""Marks for the function that describes a launch test, and for its cases."""

from __future__ import annotations

import functools
import time
import unittest
from collections.abc import Callable


def keep_alive(test_description: Callable) -> Callable:
    """Do not end the launch when no process is left: the tests end it."""
    markers = dict(getattr(test_description, '__markers__', {}), keep_alive=True)
    test_description.__markers__ = markers
    return test_description


def retry_on_failure(*, times: int, delay: float = 0.0) -> Callable[[Callable], Callable]:
    """
    Run a case again when it fails, up to so many times in all.

    :param delay: seconds between two runs
    """
    if times < 1:
        raise ValueError(f"'times' of retry_on_failure has to be at least 1, got {times}")

    def decorate(case: Callable) -> Callable:
        @functools.wraps(case)
        def run(self: unittest.TestCase, *args, **kwargs):
            for _ in range(times - 1):
                try:
                    return case(self, *args, **kwargs)
                except self.failureException:
                    time.sleep(delay)
            return case(self, *args, **kwargs)

        return run

    return decorate
