"""Fixtures that launch."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import pytest
from launch import LaunchDescription

from launch_pytest.running import Running


@dataclass(frozen=True)
class Options:
    """What a launch fixture is like."""

    name: str
    scope: str
    shutdown_when_idle: bool
    auto_shutdown: bool


_runs: dict[int, Running] = {}  # by the identity of what the fixture gives


def fixture(
    decorated: Callable | None = None, *, shutdown_when_idle: bool = True, auto_shutdown: bool = True, **kwargs: Any
):
    """
    Make a function that returns a launch description a fixture that launches it.

    The function may also return a sequence whose first item is the description.

    :param shutdown_when_idle: end the launch when no process is left
    :param auto_shutdown: end the launch when the tests are done, instead of waiting for its own end
    :param kwargs: those of ``pytest.fixture``
    """

    def decorate(function: Callable):
        options = Options(
            kwargs.get('name') or function.__name__, kwargs.get('scope', 'function'), shutdown_when_idle, auto_shutdown
        )
        made = pytest.fixture(_launching(function, options), **kwargs)
        made._launch_pytest_options = options
        return made

    return decorate if decorated is None else decorate(decorated)


def options_of(launch_fixture: Any) -> Options | None:
    """Return what a fixture is like; None if it is no launch fixture."""
    return getattr(launch_fixture, '_launch_pytest_options', None)


def run_of(value: Any) -> Running:
    """Return the launch behind what a launch fixture has given."""
    return _runs[id(value)]


def _launching(function: Callable, options: Options) -> Callable[..., Iterator]:
    @functools.wraps(function)
    def launch(*args: Any, **kwargs: Any) -> Iterator:
        made = function(*args, **kwargs)
        value = next(made) if inspect.isgenerator(made) else made
        running = Running(
            _description(value, options.name),
            shutdown_when_idle=options.shutdown_when_idle,
            auto_shutdown=options.auto_shutdown,
        )
        _runs[id(value)] = running
        try:
            yield value
            running.finish()
        finally:
            del _runs[id(value)]
            running.close()
            if inspect.isgenerator(made):
                next(made, None)

    return launch


def _description(value: Any, name: str) -> LaunchDescription:
    description = value[0] if isinstance(value, Sequence) and value else value
    if not isinstance(description, LaunchDescription):
        raise TypeError(
            f"When running launch_pytest fixture '{name}': return value must be either a launch "
            'description or a sequence which first item is a launch description'
        )
    return description
