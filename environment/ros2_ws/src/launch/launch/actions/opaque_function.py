"""Runs the launch file's own function while launching."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from launch.action import Action
from launch.launch_context import LaunchContext
from launch.utilities import to_entities


class OpaqueFunction(Action):
    """Calls a function with the context and the arguments; the entities it returns are visited."""

    def __init__(self, *, function: Callable, args: Iterable | None = None, kwargs: dict | None = None, **more):
        super().__init__(**more)
        if not callable(function):
            raise TypeError(f"OpaqueFunction expected a callable for 'function', got {function!r}")
        self._function, self._args, self._kwargs = function, list(args or []), dict(kwargs or {})

    def describe(self) -> str:
        return f"OpaqueFunction('{getattr(self._function, '__name__', self._function)}')"

    def execute(self, context: LaunchContext) -> list:
        return to_entities(self._function(context, *self._args, **self._kwargs))
