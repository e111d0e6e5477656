"""From a module with a launch test to the launches and the cases for each."""

from __future__ import annotations

import functools
import inspect
import unittest
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

from launch.launch_description import LaunchDescription

from launch_testing.actions.ready import find_ready_actions

_READY_TIMEOUT = 15.0  # seconds


class TestRun:
    """
    One launch, and the cases that run while it runs and after its end.

    :param name: what the run is called in reports
    :param test_description_function: returns the launch description, or a tuple of it and a dictionary
    :param param_args: the values of ``parametrize`` for this launch
    """

    __test__ = False  # for pytest: this is no class of cases

    def __init__(
        self,
        name: str,
        test_description_function: Callable,
        param_args: dict[str, Any],
        pre_shutdown_tests: unittest.TestSuite,
        post_shutdown_tests: unittest.TestSuite,
    ):
        self.name, self.param_args = name, param_args
        self.pre_shutdown_tests, self.post_shutdown_tests = pre_shutdown_tests, post_shutdown_tests
        self._describe = test_description_function
        self._cases = [*_cases(pre_shutdown_tests), *_cases(post_shutdown_tests)]  # a suite forgets those it has run
        if param_args:
            for case in self.all_cases():
                _rename(case, self._values())

    @property
    def markers(self) -> dict[str, Any]:
        """The marks of ``launch_testing.markers``."""
        return getattr(self._describe, '__markers__', {})

    @property
    def timeout(self) -> float:
        """Seconds to wait for ReadyToTest."""
        return getattr(self._describe, '__ready_to_test_action_timeout__', _READY_TIMEOUT)

    def normalized_test_description(self, *, ready_fn: Callable[[], None]) -> tuple[LaunchDescription, dict[str, Any]]:
        """
        Return the launch description and what it gives to the cases.

        :param ready_fn: called when the system is ready
        :raises RuntimeError: if there is no ReadyToTest in it
        :raises TypeError: if it is no launch description
        """
        result = self._describe()
        description, context = result if isinstance(result, tuple) else (result, {})
        if not isinstance(description, LaunchDescription):
            raise TypeError(
                'generate_test_description functions must return a LaunchDescription, or a tuple of one '
                f'and a dictionary; got {description!r}'
            )
        ready = find_ready_actions(description)
        if not ready:
            raise RuntimeError(
                'generate_test_description functions must return a LaunchDescription containing a ReadyToTest action'
            )
        ready[0]._add_callback(ready_fn)
        return description, dict(context)

    def check_arguments(self) -> None:
        """
        Look at the arguments of the function that describes the launch, without a call.

        :raises TypeError: if it wants one that nobody gives it, or does not take one of ``parametrize``
        """
        taken = inspect.signature(self._describe).parameters
        takes_any = any(one.kind is one.VAR_KEYWORD for one in taken.values())
        for name in () if takes_any else self.param_args.keys() - taken.keys():
            raise TypeError(f"Could not find an argument of generate_test_description named '{name}'")
        for name, one in taken.items():
            given = name in self.param_args or one.default is not one.empty
            if not given and one.kind not in (one.VAR_POSITIONAL, one.VAR_KEYWORD):
                raise TypeError(f"generate_test_description has an unexpected extra argument '{name}'")

    def get_launch_description(self) -> LaunchDescription:
        """Return the launch description, only to look at it."""
        return self.normalized_test_description(ready_fn=lambda: None)[0]

    def bind(self, tests: unittest.TestSuite, values: dict[str, Any]) -> None:
        """Give values to the cases: as attributes, and as arguments of the same name to their methods."""
        for case in _cases(tests):
            for method in (case._testMethodName, 'setUp', 'tearDown'):
                setattr(case, method, _bound(getattr(case, method), values))
        for kind in {type(case): None for case in _cases(tests)}:
            for name in ('proc_info', 'proc_output', 'test_args', 'launch_service'):
                if name in values:
                    setattr(kind, name, values[name])
            for method in ('setUpClass', 'tearDownClass'):
                setattr(kind, method, _bound(getattr(kind, method), values))

    def all_cases(self) -> Iterator[unittest.TestCase]:
        """Return all cases."""
        return iter(self._cases)

    def __str__(self) -> str:
        return self.name + self._values()

    def _values(self) -> str:
        return f'[{", ".join(map(str, self.param_args.values()))}]' if self.param_args else ''


def LoadTestsFromPythonModule(module: ModuleType, *, name: str = 'launch_tests') -> list[TestRun]:
    """
    Return one run for each launch that the module's ``generate_test_description`` describes.

    :raises AttributeError: if the module has no such function
    """
    describe = module.generate_test_description
    launches = describe() if getattr(describe, '__parametrized__', False) else [(describe, {})]
    return [
        TestRun(
            name,
            function,
            values,
            _Loader(post_shutdown=False).loadTestsFromModule(module),
            _Loader(post_shutdown=True).loadTestsFromModule(module),
        )
        for function, values in launches
    ]


class _Loader(unittest.TestLoader):
    """Loads the cases of before, or of after the end of the launch."""

    def __init__(self, *, post_shutdown: bool):
        super().__init__()
        self._post_shutdown = post_shutdown

    def loadTestsFromTestCase(self, testCaseClass: type[unittest.TestCase]) -> unittest.TestSuite:
        if getattr(testCaseClass, '__post_shutdown_test__', False) != self._post_shutdown:
            return self.suiteClass()
        # A class of its own for each run, as values are bound to it.
        names = {key: getattr(testCaseClass, key) for key in ('__module__', '__qualname__', '__doc__')}
        return super().loadTestsFromTestCase(type(testCaseClass.__name__, (testCaseClass,), names))


def _cases(suite: unittest.TestSuite | unittest.TestCase) -> Iterator[unittest.TestCase]:
    if isinstance(suite, unittest.TestCase):
        yield suite
        return
    for part in suite:
        yield from _cases(part)


def _rename(case: unittest.TestCase, suffix: str) -> None:
    method = getattr(case, case._testMethodName)
    case._testMethodName += suffix
    setattr(case, case._testMethodName, method)


def _bound(method: Callable, values: dict[str, Any]) -> Callable:
    """Return a method with the values that it has arguments for, and with its marks, such as that of a skip."""
    wanted = inspect.signature(method).parameters
    bound = functools.partial(method, **{name: value for name, value in values.items() if name in wanted})
    return functools.update_wrapper(bound, method)
