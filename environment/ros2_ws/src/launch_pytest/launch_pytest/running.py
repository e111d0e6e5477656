"""A launch in a thread of its own, for as long as a fixture lives."""

from __future__ import annotations

import asyncio
import concurrent.futures
import threading
from collections.abc import Coroutine
from typing import Any

from launch import LaunchDescription, LaunchService
from launch_testing.actions.ready import ReadyToTest, find_ready_actions

PATIENCE = 60.0  # seconds until the system has to be ready, and for its end
_JOIN = 10.0  # seconds


class LaunchFailed(Exception):
    """The launch has not become ready, or has not ended well."""


class Running:
    """
    A launch that is ready for tests.

    :raises LaunchFailed: if it does not become so
    """

    def __init__(self, description: LaunchDescription, *, shutdown_when_idle: bool, auto_shutdown: bool):
        self._auto_shutdown = auto_shutdown
        self.loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self.loop.run_forever, name='launch_pytest', daemon=True)
        self._thread.start()
        self.service: LaunchService = self.do(self._make())
        self._ready = threading.Event()
        ready = find_ready_actions(description)
        if len(ready) > 1:
            raise RuntimeError(
                'launch_pytest fixtures must return a LaunchDescription containing only one ReadyToTest action'
            )
        if not ready:
            ready = [ReadyToTest()]
            description.add_action(ready[0])
        ready[0]._add_callback(self._ready.set)
        self.service.include_launch_description(description)
        self._result = asyncio.run_coroutine_threadsafe(
            self.service.run_async(shutdown_when_idle=shutdown_when_idle), self.loop
        )
        self._result.add_done_callback(lambda _: self._ready.set())
        self._wait_until_ready()

    async def _make(self) -> LaunchService:
        """Make the service in its own loop, as its context belongs to that."""
        return LaunchService(noninteractive=True)

    def _wait_until_ready(self) -> None:
        if not self._ready.wait(PATIENCE):
            self.close()
            raise LaunchFailed(f'the launch was not ready for tests within {PATIENCE:g} s')
        if self._result.done() and self._result.result() != 0:
            self.close()
            raise LaunchFailed('the launch ended with an error before it was ready for tests; its log says why')

    def do(self, coroutine: Coroutine, timeout: float | None = None) -> Any:
        """Run a coroutine in the launch's loop; return its result."""
        return asyncio.run_coroutine_threadsafe(coroutine, self.loop).result(timeout)

    def finish(self) -> None:
        """
        Wait for the end of the launch; by default make it end. Harmless if it has ended.

        :raises LaunchFailed: if it ends with an error, or not at all
        """
        if self._auto_shutdown:
            self.service.shutdown()
        try:
            status = self._result.result(PATIENCE)
        except concurrent.futures.TimeoutError:
            raise LaunchFailed(f'the launch did not end within {PATIENCE:g} s') from None
        if status != 0:
            raise LaunchFailed(f'the launch service failed when finishing, return code {status}; its log says why')

    def close(self) -> None:
        """Leave nothing behind."""
        if not self._result.done():
            self.service.shutdown()
            concurrent.futures.wait([self._result], PATIENCE)
        self.loop.call_soon_threadsafe(self.loop.stop)
        self._thread.join(_JOIN)
        if not self._thread.is_alive():
            self.loop.close()
