"""Runs the launch file's own coroutine while launching."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Iterable

from launch.action import Action
from launch.event_handlers import OnShutdown
from launch.launch_context import LaunchContext


class OpaqueCoroutine(Action):
    """Starts a coroutine; it is cancelled when the system shuts down."""

    def __init__(
        self,
        *,
        coroutine: Callable[..., Awaitable],
        args: Iterable | None = None,
        kwargs: dict | None = None,
        ignore_context: bool = False,
        **more,
    ):
        super().__init__(**more)
        self._coroutine, self._args, self._kwargs = coroutine, list(args or []), dict(kwargs or {})
        self._ignore_context = ignore_context
        self._task: asyncio.Task | None = None

    def execute(self, context: LaunchContext) -> None:
        first = [] if self._ignore_context else [context]
        self._task = context.asyncio_loop.create_task(self._coroutine(*first, *self._args, **self._kwargs))

        def cancel(event, context) -> None:
            self._task.cancel()

        context.register_event_handler(OnShutdown(on_shutdown=cancel))

    def get_asyncio_future(self) -> asyncio.Future | None:
        return self._task
