"""The pytest side: the `learner` fixture, and results as data instead of a report.

Loaded by `helpers.runner.tester` in a process of its own. Each test's result goes out as soon as it is known, so that a
process that dies loses only the test that was running.
"""

import faulthandler
import inspect
import json
import os
import signal
import sys
import traceback
from collections.abc import Callable
from dataclasses import replace

import pytest

from helpers.exercises import manifest
from helpers.runner import verdicts
from helpers.runner.fork_client import ForkServer
from helpers.runner.learner import Learner
from helpers.runner.load import busy
from helpers.runner.seeds import generator
from helpers.runner.timeouts import AGAIN, TIMEOUTS

STUCK = 1.5  # so many times as long as a test may take all that comes before and after it, too


class Plugin:
    """One run: which programs there are, and where results go."""

    def __init__(
        self,
        programs: dict[str, dict],
        server: ForkServer,
        domain_id: int,
        report: Callable[[dict], None],
        only: set[str] | None = None,
        named: dict[str, list[str]] | None = None,
        *,
        seed: str,
        seeds: dict[str, str],
        limit: float = 0.0,
        share: tuple[int, int] = (0, 1),
    ):
        """`programs` by exercise id; tests of other exercises are left out. `only`: the ids of the tests to run.

        `named`: for an exercise, the names of the tests that count; its others are as if they were not there.
        `seed`: what the tests draw is derived from it; from `seeds[exercise]` where there is one.
        `limit`: seconds of wall time for one test, all that it waits for included; longer on a busy machine.
        `share`: first and step: which of the tests are there for this run, if another one has the others.
        """
        self.programs, self.server, self.domain_id = programs, server, domain_id
        self.report, self.only, self.named, self.seed, self.seeds = report, only, named or {}, seed, seeds
        self._limits, self._limit = server.limits, limit
        self._first, self._every = share
        self._stuck: set[str] = set()  # exercises of which a test has met a timeout

    def pytest_configure(self, config):
        config.addinivalue_line('markers', 'exercise(id): the exercise that a test judges')
        config.addinivalue_line('markers', 'given: the cell passes the test as it was given, see results.TestResult')
        config.addinivalue_line('markers', 'limits(name=value): other bounds for the program, see launch.Limits')
        config.addinivalue_line('markers', 'not_looked_at(rule, why): a rule that no visible test can see')
        config.addinivalue_line('markers', 'may_take(seconds): of wall time, if a right program needs more than others')
        config.addinivalue_line('markers', 'rules(*names): the rules of the card that a test looks at')
        config.addinivalue_line('markers', 'weight(n): how much a test counts within its exercise; 1 by default')
        config.addinivalue_line('markers', 'wiring(type=, qos=, namespace=): the rules that are broken then')

    def pytest_ignore_collect(self, collection_path):
        """Leave out the files of other exercises, which would only cost time."""
        return manifest.tested_in(collection_path) not in (None, *self.programs) or None

    def pytest_collection_modifyitems(self, items):
        """Tell which tests there are, and keep those that are to run now."""
        kept = []
        for item in [item for item in items if self._counts(item)][self._first :: self._every]:
            exercise, test = _exercise(item), test_id(item)
            self.report(
                {
                    'event': 'collected',
                    'test': test,
                    'exercise': exercise,
                    'weight': _weight(item),
                    'path': str(item.path),
                    'expected': inspect.cleandoc(item.function.__doc__ or ''),
                    'rules': rules(item),
                    'given': item.get_closest_marker('given') is not None,
                    'unseen': {
                        marker.kwargs['rule']: marker.kwargs['why'] for marker in item.iter_markers('not_looked_at')
                    },
                }
            )
            if self.only is None or test in self.only:
                kept.append(item)
        items[:] = kept

    def _counts(self, item) -> bool:
        """Whether it is a test of one of the exercises, and one of those that count."""
        exercise = _exercise(item)
        if exercise not in self.programs:
            return False
        named = self.named.get(exercise, [item.name])
        return bool({item.name, item.originalname} & set(named))

    @pytest.hookimpl(hookwrapper=True)
    def pytest_make_collect_report(self, collector):
        outcome = yield
        report = outcome.get_result()
        if report.failed:
            self.report({'event': 'broken', 'where': _place(collector.path), 'text': str(report.longrepr)[-4000:]})

    @pytest.fixture
    def learner(self, request):
        """The learner's program, fresh for each test."""
        exercise = _exercise(request.node)
        marker = request.node.get_closest_marker('limits')
        self.server.limits = replace(self._limits, **(marker.kwargs if marker else {}))
        learner = Learner(
            self.server,
            self.programs[exercise],
            self.domain_id,
            AGAIN if exercise in self._stuck else TIMEOUTS,
            random=generator(self.seeds.get(exercise, self.seed), test_id(request.node)),
            relative=any('namespace' in marker.kwargs for marker in request.node.iter_markers('wiring')),
        )
        request.node.learner = learner
        yield learner
        try:
            learner.close()
        finally:
            self.server.clear()

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_call(self, item):
        """End a test that takes too long, however many things of the learner's it waits for, or reads."""
        signal.signal(signal.SIGALRM, _too_long)
        signal.setitimer(signal.ITIMER_REAL, self._longest(item), 5.0)  # again, if somebody catches it
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)

    def _longest(self, item) -> float:
        """Seconds of wall time for a test."""
        return max(self._limit, may_take(item)) * (3 if busy() else 1)

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(self, item, call):
        outcome = yield
        result = outcome.get_result()
        state = item.stash.setdefault(_STATE, {**_NOTHING})
        if call.excinfo is not None and not (state['verdict'] and call.when == 'teardown'):
            state.update(self._verdict(item, call.excinfo))
        elif call.when == 'call' and result.passed:
            state['verdict'] = verdicts.PASSED
        if call.when == 'teardown' and call.excinfo is not None and state['verdict'] == verdicts.PASSED:
            # The tests' side could not clean up, so its result cannot be trusted.
            state.update(self._verdict(item, call.excinfo))

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item):
        self.report({'event': 'running', 'test': test_id(item), 'may_take': may_take(item)})
        verdicts.met.clear()
        # A test that is stuck where no signal ends it ends together with this process.
        faulthandler.dump_traceback_later(STUCK * self._longest(item), exit=True, file=sys.__stderr__)
        yield
        faulthandler.cancel_dump_traceback_later()
        state = item.stash.get(_STATE, {**_NOTHING, 'fault': 'no report'})
        learner = getattr(item, 'learner', None)
        if state['verdict'] == verdicts.TIMEOUT:
            self._stuck.add(_exercise(item))
        self.report(
            {
                'event': 'result',
                'test': test_id(item),
                'message': state['message'],
                'verdict': state['verdict'] or verdicts.GRADER_ERROR,
                'details': state['details'],
                'rule': state['rule'],
                'hint': state['hint'],
                'again': state['again'],
                'so_far': [rule for rule in rules(item) if rule in verdicts.met and rule != state['rule']],
                'fault': state['fault'],
                'output': learner.output if learner else '',
            }
        )

    def _verdict(self, item, excinfo) -> dict:
        """The verdict of an exception: the learner's, or ours."""
        error = excinfo.value
        state = {**_NOTHING, 'verdict': verdicts.GRADER_ERROR}
        if isinstance(error, verdicts.LearnerError):
            causes, hints = [], []
            if isinstance(error, verdicts.ExpectationFailed):
                causes, hints = self._said(item, 'causes'), self._said(item, 'hints')
            return {
                **state,
                'again': isinstance(error, verdicts.Unheard),
                'verdict': error.verdict,
                'message': '\n'.join([*causes, error.message, *hints]),
                'details': error.details,
                'rule': _broken_rule(item, error),
                'hint': error.hint,
            }
        if isinstance(error, AssertionError):  # a bare assert: the docstring must do
            return {
                **state,
                'verdict': verdicts.FAILED,
                'message': '\n'.join([*self._said(item, 'causes'), *self._said(item, 'hints')]),
                'hint': True,
                'rule': _broken_rule(item, None),
            }
        text = ''.join(traceback.format_exception(error))
        return {**state, 'fault': text[-8000:]}

    def _said(self, item, what: str) -> list[str]:
        """The `causes` or the `hints` of the test's learner."""
        try:
            return getattr(item.learner, what)()
        except Exception:  # noqa: BLE001 - a hint is only a hint
            return []


_STATE = pytest.StashKey[dict]()
# A test of which nothing is known yet.
_NOTHING = {'verdict': None, 'message': '', 'details': '', 'fault': '', 'rule': '', 'hint': False, 'again': False}


def _too_long(*_) -> None:
    raise verdicts.Unheard(
        'This test took too long with your program: it waited again and again, or what your program '
        'gave takes very long to be read.'
    )


def test_id(item) -> str:
    """A test's name that is the same on every machine: folders, file, function, parameters."""
    return f'{_place(item.path.with_suffix(""))}::{item.name}'


vars(test_id)['__test__'] = False  # for pytest


def _place(path) -> str:
    return '/'.join(path.parts[-3:])


def _exercise(item) -> str | None:
    marker = item.get_closest_marker('exercise')
    return str(marker.args[0]) if marker and marker.args else None


def _weight(item) -> float:
    marker = item.get_closest_marker('weight')
    return float(marker.args[0]) if marker and marker.args else 1.0


def may_take(item) -> float:
    """Seconds of wall time that a test may take, where that is more than the session says; else 0."""
    marker = item.get_closest_marker('may_take')
    return float(marker.args[0]) if marker else 0.0


def rules(item) -> list[str]:
    """The rules of the card that a test looks at, in its own order."""
    return list(dict.fromkeys(name for marker in item.iter_markers('rules') for name in marker.args))


def _broken_rule(item, error: verdicts.LearnerError | None) -> str:
    """The rule that the error breaks: what the error says; else the test's only one; '' if nobody knows."""
    if error is not None and error.rule:
        return error.rule
    if isinstance(error, verdicts.WiringError):
        for marker in item.iter_markers('wiring'):
            if error.kind in marker.kwargs:
                return marker.kwargs[error.kind]
    looked_at = rules(item)
    return looked_at[0] if len(looked_at) == 1 else ''


def reporter(descriptor: int) -> Callable[[dict], None]:
    """A function that writes events as JSON lines to a file descriptor."""

    def report(event: dict) -> None:
        os.write(descriptor, json.dumps(event).encode() + b'\n')

    return report
