"""Run the launch file's own code while launching."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Iterable

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


class OpaqueCoroutine(Action):
    """Starts a coroutine; it is cancelled when the system shuts down."""

    def __init__(self, *, coroutine: Callable[..., Awaitable], args=None, kwargs=None, ignore_context=False, **more):
        super().__init__(**more)
        self._coroutine, self._args, self._kwargs = coroutine, list(args or []), dict(kwargs or {})
        self._ignore_context = ignore_context
        self._task: asyncio.Task | None = None

    def execute(self, context: LaunchContext) -> None:
        from launch.event_handlers import OnShutdown

        first = [] if self._ignore_context else [context]
        self._task = context.asyncio_loop.create_task(self._coroutine(*first, *self._args, **self._kwargs))

        def cancel(event, context) -> None:
            self._task.cancel()

        context.register_event_handler(OnShutdown(on_shutdown=cancel))

    def get_asyncio_future(self) -> asyncio.Future | None:
        return self._task
