"""Launches, and runs the cases."""

from __future__ import annotations

import threading
import unittest
from collections.abc import Iterable

from launch import LaunchDescription, LaunchDescriptionSource, LaunchService
from launch.actions import IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart

from launch_testing.io_handler import ActiveIoHandler
from launch_testing.loader import TestRun
from launch_testing.proc_info_handler import ActiveProcInfoHandler
from launch_testing.test_result import FailResult, SkipResult, TestResult


def parse_launch_arguments(launch_arguments: Iterable[str]) -> list[tuple[str, str]]:
    """
    Return the names and values of ``name:=value`` words; of several of one name the last counts.

    :raises RuntimeError: for a word of another form
    """
    parsed = {}
    for argument in launch_arguments:
        name, found, value = argument.partition(':=')
        if not found or not name:
            raise RuntimeError(f"malformed launch argument '{argument}', expected format '<name>:=<value>'")
        parsed[name] = value
    return list(parsed.items())


class _Worker:
    """One launch in this thread, and the cases of before its end in another."""

    def __init__(self, run: TestRun, arguments: list[tuple[str, str]], debug: bool):
        self._run, self._arguments = run, arguments
        self._service = LaunchService(noninteractive=True, debug=debug)
        self._ready, self._ended = threading.Event(), threading.Event()
        self._proc_info, self._proc_output = ActiveProcInfoHandler(), ActiveIoHandler()
        self._result: TestResult | None = None
        self._failure = 'Processes under test stopped before tests completed'

    def work(self) -> TestResult | FailResult:
        """Launch and test."""
        description, context = self._run.normalized_test_description(ready_fn=self._ready.set)
        values = {
            **context,
            **self._run.param_args,
            'test_args': dict(self._arguments),
            'launch_service': self._service,
            'proc_info': self._proc_info,
            'proc_output': self._proc_output,
        }
        self._run.bind(self._run.pre_shutdown_tests, values)
        values |= {'proc_info': self._proc_info._proc_info_handler, 'proc_output': self._proc_output._io_handler}
        self._run.bind(self._run.post_shutdown_tests, values)
        self._service.include_launch_description(self._watched(description))
        tests = threading.Thread(target=self._test, name='launch_testing')
        tests.start()
        try:
            self._service.run(shutdown_when_idle=not self._run.markers.get('keep_alive', False))
        finally:
            self._ended.set()
            self._ready.set()
            tests.join()
        if self._result is None:
            print(self._failure)
            self._print_failed_processes()
            return FailResult(self._run, self._failure)
        self._result.append(_run_suite(self._run.post_shutdown_tests))
        return self._result

    def _watched(self, description: LaunchDescription) -> LaunchDescription:
        def note(event, context) -> None:
            self._proc_info.append(event)

        return LaunchDescription(
            [
                RegisterEventHandler(OnProcessStart(on_start=note)),
                RegisterEventHandler(OnProcessExit(on_exit=note)),
                RegisterEventHandler(
                    OnProcessIO(on_stdout=self._proc_output.append, on_stderr=self._proc_output.append)
                ),
                IncludeLaunchDescription(LaunchDescriptionSource(description), launch_arguments=self._arguments),
            ]
        )

    def _test(self) -> None:
        if not self._ready.wait(self._run.timeout):
            self._failure = 'Timed out waiting for processes to start up'
        elif not self._ended.is_set():
            result = _run_suite(self._run.pre_shutdown_tests)
            if not self._ended.is_set():  # otherwise the cases have not seen a running system
                self._result = result
        self._service.shutdown()

    def _print_failed_processes(self) -> None:
        for info in self._proc_info:
            code = getattr(info, 'returncode', 0)
            if code == 0 or info.process_name not in self._proc_output.process_names():
                continue
            print(f"Process '{info.process_name}' exited with {code}")
            print(f"##### '{info.process_name}' output #####")
            print(b''.join(part.text for part in self._proc_output[info.action]).decode(errors='replace'))
            print('#' * (len(info.process_name) + 21))


def _run_suite(suite: unittest.TestSuite) -> TestResult:
    return unittest.TextTestRunner(verbosity=2, resultclass=TestResult).run(suite)


class LaunchTestRunner:
    """
    Does all runs of a module, one after the other.

    :param launch_file_arguments: ``name:=value`` words
    :param debug: log more
    """

    def __init__(self, test_runs: list[TestRun], launch_file_arguments: Iterable[str] = (), debug: bool = False):
        self._runs, self._debug = test_runs, debug
        self._arguments = parse_launch_arguments(launch_file_arguments)

    def run(self) -> dict[TestRun, unittest.TestResult]:
        """Launch and test; return the result of each run that has been done."""
        results: dict[TestRun, unittest.TestResult] = {}
        for number, run in enumerate(self._runs, 1):
            if len(self._runs) > 1:
                print(f'Starting test run {number}')
            try:
                results[run] = _Worker(run, self._arguments, self._debug).work()
            except unittest.SkipTest as skip:
                print(f'{run} is skipped: {skip}')
                results[run] = SkipResult(run, str(skip))
            if isinstance(results[run], FailResult):  # most likely the user's Ctrl+C
                break
        return results

    def validate(self) -> None:
        """
        Check what can be checked before anything is launched.

        :raises TypeError: if a function wants an argument that nobody gives it
        """
        for run in self._runs:
            run.check_arguments()
