"""The pytest side: the `learner` fixture, and results as data instead of a report.

Loaded by `helpers.runner.tester` in a process of its own. Each test's result goes out as soon as it is known, so that a
process that dies loses only the test that was running.
"""
import inspect
import json
import os
import traceback
from collections.abc import Callable
from dataclasses import replace

import pytest

from helpers.exercises import manifest
from helpers.runner import seeds, verdicts
from helpers.runner.client import ForkServer
from helpers.runner.learner import AGAIN, TIMEOUTS, Learner


class Plugin:
    """One run: which programs there are, and where results go."""

    def __init__(self, programs: dict[str, dict], server: ForkServer, domain_id: int, report: Callable[[dict], None],
                 only: set[str] | None = None, named: dict[str, list[str]] | None = None, *, seed: str):
        """`programs` by exercise id; tests of other exercises are left out. `only`: the ids of the tests to run.

        `named`: for an exercise, the names of the tests that count; its others are as if they were not there.
        `seed`: what the tests draw is derived from it.
        """
        self.programs, self.server, self.domain_id = programs, server, domain_id
        self.report, self.only, self.named, self.seed = report, only, named or {}, seed
        self._limits = server.limits
        self._stuck: set[str] = set()  # exercises of which a test has met a timeout

    def pytest_configure(self, config):
        config.addinivalue_line('markers', 'exercise(id): the exercise that a test judges')
        config.addinivalue_line('markers', 'limits(name=value): other bounds for the program, see launch.Limits')
        config.addinivalue_line('markers', 'weight(n): how much a test counts within its exercise; 1 by default')

    def pytest_ignore_collect(self, collection_path):
        """Leave out the files of other exercises, which would only cost time."""
        return manifest.tested_in(collection_path.name) not in (None, *self.programs) or None

    def pytest_collection_modifyitems(self, items):
        """Tell which tests there are, and keep those that are to run now."""
        kept = []
        for item in items:
            exercise = _exercise(item)
            if exercise not in self.programs or item.name not in self.named.get(exercise, [item.name]):
                continue
            test = test_id(item)
            self.report({'event': 'collected', 'test': test, 'exercise': exercise, 'weight': _weight(item),
                         'path': str(item.path), 'expected': inspect.cleandoc(item.function.__doc__ or '')})
            if self.only is None or test in self.only:
                kept.append(item)
        items[:] = kept

    def pytest_collectreport(self, report):
        if report.failed:
            self.report({'event': 'broken', 'where': report.nodeid, 'text': str(report.longrepr)[-4000:]})

    @pytest.fixture
    def learner(self, request):
        """The learner's program, fresh for each test."""
        exercise = _exercise(request.node)
        marker = request.node.get_closest_marker('limits')
        self.server.limits = replace(self._limits, **(marker.kwargs if marker else {}))
        learner = Learner(self.server, self.programs[exercise], self.domain_id,
                          AGAIN if exercise in self._stuck else TIMEOUTS,
                          random=seeds.generator(self.seed, test_id(request.node)))
        request.node.learner = learner
        yield learner
        try:
            learner.close()
        finally:
            self.server.clear()

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(self, item, call):
        outcome = yield
        result = outcome.get_result()
        state = item.stash.setdefault(_STATE, {'verdict': None, 'message': '', 'details': '', 'fault': ''})
        if call.excinfo is not None and not (state['verdict'] and call.when == 'teardown'):
            state.update(self._judge(item, call.excinfo))
        elif call.when == 'call' and result.passed:
            state['verdict'] = verdicts.PASSED
        if call.when == 'teardown' and call.excinfo is not None and state['verdict'] == verdicts.PASSED:
            # The tests' side could not clean up: what it saw is not to be trusted.
            state.update(self._judge(item, call.excinfo))

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item):
        self.report({'event': 'running', 'test': test_id(item)})
        yield
        state = item.stash.get(_STATE, {'verdict': None, 'message': '', 'details': '', 'fault': 'no report'})
        learner = getattr(item, 'learner', None)
        if state['verdict'] == verdicts.TIMEOUT:
            self._stuck.add(_exercise(item))
        self.report({'event': 'result', 'test': test_id(item), 'message': state['message'],
                     'verdict': state['verdict'] or verdicts.GRADER_ERROR, 'details': state['details'],
                     'fault': state['fault'], 'output': learner.output if learner else ''})

    def _judge(self, item, excinfo) -> dict:
        """The verdict of an exception: the learner's, or ours."""
        error = excinfo.value
        state = {'verdict': verdicts.GRADER_ERROR, 'message': '', 'details': '', 'fault': ''}
        if isinstance(error, verdicts.LearnerFault):
            hints = []
            if isinstance(error, verdicts.ExpectationFailed):
                hints = self._hints(item)
            return {**state, 'verdict': error.verdict, 'message': '\n'.join([error.message, *hints]),
                    'details': error.details}
        if isinstance(error, AssertionError):  # a bare assert: the docstring must do
            return {**state, 'verdict': verdicts.FAILED, 'message': '\n'.join(self._hints(item))}
        text = ''.join(traceback.format_exception(error))
        return {**state, 'fault': text[-8000:]}

    def _hints(self, item) -> list[str]:
        try:
            return item.learner.hints()
        except Exception:  # noqa: BLE001 - a hint is only a hint
            return []


_STATE = pytest.StashKey[dict]()


def test_id(item) -> str:
    """A test's name that is the same on every machine: folders, file, function, parameters."""
    folder = item.path.parent
    return f'{folder.parent.name}/{folder.name}/{item.path.stem}::{item.name}'


test_id.__test__ = False


def _exercise(item) -> str | None:
    marker = item.get_closest_marker('exercise')
    return str(marker.args[0]) if marker and marker.args else None


def _weight(item) -> float:
    marker = item.get_closest_marker('weight')
    return float(marker.args[0]) if marker and marker.args else 1.0


def reporter(descriptor: int) -> Callable[[dict], None]:
    """A function that writes events as JSON lines to a file descriptor."""
    def report(event: dict) -> None:
        os.write(descriptor, json.dumps(event).encode() + b'\n')
    return report
