"""
Launch tests under pytest: a module whose ``generate_test_description`` has the mark ``launch_test`` is one test.

Every pytest run of the installation imports this module. So it stands outside of the package, and imports that, and
``launch`` with it, only when there is a launch test.
"""

from __future__ import annotations

import unittest
from pathlib import Path

import pytest

MARKS = {'launch_test'}  # launch_testing_ros adds its own
_ENTRY = 'generate_test_description'


class LaunchTestFailure(Exception):
    """Cases have failed."""

    def __init__(self, results: dict):
        super().__init__('some test cases have failed')
        self.results = results


class LaunchTestItem(pytest.Item):
    """All launches of a module, with all their cases."""

    def runtest(self) -> None:
        from launch_testing.loader import LoadTestsFromPythonModule
        from launch_testing.test_result import SkipResult
        from launch_testing.test_runner import LaunchTestRunner

        module = self.parent.obj
        arguments = [word for words in self.config.getoption('--launch-args') for word in words]
        runner = LaunchTestRunner(
            test_runs=LoadTestsFromPythonModule(module, name=module.__name__),
            launch_file_arguments=arguments,
            debug=self.config.get_verbosity() > 1,
        )
        runner.validate()
        results = runner.run()
        if not all(result.wasSuccessful() for result in results.values()):
            raise LaunchTestFailure(results)
        if all(isinstance(result, SkipResult) for result in results.values()):
            pytest.skip('; '.join(result.message for result in results.values()))

    def repr_failure(self, excinfo, style=None):
        """Show the cases that failed, or why they could not run."""
        if not isinstance(excinfo.value, LaunchTestFailure):
            return super().repr_failure(excinfo, style)
        parts = []
        for run, result in excinfo.value.results.items():
            failed = [*result.errors, *result.failures]
            told = [f'{_name(case)} failed{_why(text)}\n{text.rstrip()}' for case, text in failed]
            if not told and not result.wasSuccessful():
                told = [f'{run} failed: {getattr(result, "message", "unexpected success")}']
            parts += told
        return '\n\n'.join(parts)

    def reportinfo(self):
        """Return what names the test in a report."""
        return self.path, 0, f'launch tests: {self.name}'


def _name(case) -> str:
    is_case = isinstance(case, unittest.TestCase)
    return f'{type(case).__name__}.{case._testMethodName}' if is_case else str(case)


def _why(report: str) -> str:
    """The error of a traceback, after a colon: JUnit files, and so `colcon test-result`, leave the end of it out."""
    after = report.rpartition('Traceback (most recent call last):')[2].splitlines()
    error = next((line for line in after if line and not line[0].isspace()), '')
    return f': {error}' if error else ''


class LaunchTestModule(pytest.Module):
    """A module that may hold a launch test; without the mark it is one like any other."""

    def collect(self):
        """Return the one test, or those of an ordinary module."""
        marks = {mark.name for mark in getattr(getattr(self.obj, _ENTRY, None), 'pytestmark', [])}
        if marks & MARKS:
            return [LaunchTestItem.from_parent(self, name=self.obj.__name__)]
        return super().collect()


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makemodule(module_path: Path, parent):
    """Take the modules that name the function; all others are left to pytest."""
    try:
        text = module_path.read_text(encoding='utf-8')
    except (OSError, UnicodeDecodeError):
        return None
    return LaunchTestModule.from_parent(parent, path=module_path) if _ENTRY in text else None


def pytest_addoption(parser) -> None:
    """Add the option for launch arguments."""
    parser.addoption('--launch-args', action='append', nargs='*', default=[], help='One or more Launch test arguments')


def pytest_configure(config) -> None:
    """Make the mark known."""
    config.addinivalue_line(
        'markers', 'launch_test: mark a generate_test_description function as a launch test entrypoint'
    )
