"""The loop that launches."""

from __future__ import annotations

import asyncio
import os
import signal
import threading
import traceback
from collections.abc import Iterable

import launch.logging
from launch.event import Event
from launch.events import IncludeLaunchDescription, Shutdown, TimerEvent
from launch.events.process import ShutdownProcess, SignalProcess
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription

_STOPPING_SIGNALS = ('SIGTERM', 'SIGHUP', 'SIGQUIT')


class LaunchService:
    """
    Visits launch descriptions, handles their events, and ends when nothing is left to do.

    :param argv: the launch arguments as typed
    :param noninteractive: True if nobody sits at a terminal
    :param debug: log more, tracebacks included
    """

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False, debug: bool = False):
        launch.logging.launch_config.level = launch.logging.DEBUG if debug else launch.logging.INFO
        self._logger = launch.logging.get_logger('launch')
        launch.logging.log_launch_config(logger=self._logger)
        self._context = LaunchContext(argv=argv, noninteractive=noninteractive)
        self._lock = threading.Lock()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task | None = None
        self._return_code = 0
        self._interrupted = False

    @property
    def context(self) -> LaunchContext:
        """The state of the launch."""
        return self._context

    @property
    def event_loop(self) -> asyncio.AbstractEventLoop | None:
        """The loop that launches; None while nothing is launched."""
        return self._loop

    @property
    def task(self) -> asyncio.Task | None:
        """The task that launches; None while nothing is launched."""
        return self._task

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        """Visit a launch description, now if the service runs, otherwise when it does. Thread-safe."""
        self.emit_event(IncludeLaunchDescription(launch_description))

    def emit_event(self, event: Event) -> None:
        """Queue an event. Thread-safe."""
        with self._lock:
            if self._loop is None:
                self._context.emit_event_sync(event)
            else:
                self._loop.call_soon_threadsafe(self._context.emit_event_sync, event)

    def shutdown(self, force_sync: bool = False) -> asyncio.Task | None:
        """
        End a running launch; ``run`` returns when every process has ended. Thread-safe.

        :return: the task that launches, to be awaited in its loop; None if nothing is launched
        :param force_sync: accepted as upstream's
        """
        with self._lock:
            if self._loop is not None:
                self._loop.call_soon_threadsafe(self._begin_shutdown, 'LaunchService.shutdown() called')
            return self._task

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """
        Launch until a shutdown, and return 0, or 1 after an error or a signal other than SIGINT.

        :param shutdown_when_idle: also end when no process and no timer is left
        """
        return asyncio.run(self.run_async(shutdown_when_idle=shutdown_when_idle))

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        """Do the same as ``run``, in a running loop."""
        loop = asyncio.get_running_loop()
        with self._lock:
            if self._loop is not None:
                raise RuntimeError('this LaunchService runs already')
            self._loop = loop
            self._task = asyncio.current_task()
        self._return_code = 0
        self._context.is_shutdown = False
        self._context.asyncio_loop = loop
        environment = dict(os.environ)
        signals = self._catch_signals(loop)
        launch.logging.launch_config.on_screen_lost = lambda: self._begin_shutdown('nobody reads the output any more')
        try:
            await self._run_loop(shutdown_when_idle)
        finally:
            await self._kill_rest()
            self._context.close()
            for number, handler in signals.items():
                loop.remove_signal_handler(number)
                signal.signal(number, handler)
            os.environ.clear()
            os.environ.update(environment)
            with self._lock:
                self._loop = self._task = None
        return self._return_code

    # --- the loop ---------------------------------------------------------------------------------------------

    async def _run_loop(self, shutdown_when_idle: bool) -> None:
        context = self._context
        while True:
            # Every turn of the loop clears the flag before it looks, so nothing that comes later is missed.
            context._wakeup.clear()
            if self._collect_futures():
                await asyncio.sleep(0)  # whoever waits for the end of a future emits an event about it only now
                continue
            if context._queue:
                for _ in range(len(context._queue)):
                    self._handle(context._queue.popleft())
            elif not context._futures and context.is_shutdown:
                return
            elif not context._futures and shutdown_when_idle:
                self._begin_shutdown('idle')
            else:
                await context._wakeup.wait()
                continue
            await asyncio.sleep(0)  # let processes and timers have their turn

    def _collect_futures(self) -> bool:
        """Forget the futures that are done; return whether there were any."""
        done = [future for future in self._context._futures if future.done()]
        self._context._futures = [future for future in self._context._futures if not future.done()]
        for future in done:
            if not future.cancelled() and future.exception() is not None:
                self._fail(future.exception())
        return bool(done)

    def _handle(self, event: Event) -> None:
        self._logger.debug(f"processing event: '{event}'")
        context = self._context
        for handler in context.event_handlers:
            if handler.matches(event):
                self._guarded(self._run_handler, handler, event)
        self._guarded(self._handle_own, event)

    def _run_handler(self, handler, event: Event) -> None:
        with self._context.local_scope():
            self._visit_all(handler.handle(event, self._context))

    def _handle_own(self, event: Event) -> None:
        """React to the events that the service itself knows."""
        context = self._context
        if isinstance(event, IncludeLaunchDescription):
            self._visit(event.launch_description)
        elif isinstance(event, TimerEvent):
            scope = context.configuration_scope(event.launch_configurations)
            with context.local_scope(event.local_variables), scope:
                self._visit_all(event.timer_action.actions)
        elif isinstance(event, Shutdown):
            context.is_shutdown = True
            for process in list(context.running_processes):
                process.request_shutdown(context, quiet=event.due_to_sigint and not context.noninteractive)
        elif isinstance(event, (ShutdownProcess, SignalProcess)):
            for process in [process for process in context.running_processes if event.process_matcher(process)]:
                if isinstance(event, ShutdownProcess):
                    process.request_shutdown(context)
                else:
                    process.send_signal(event.signal)

    def _visit_all(self, entities) -> None:
        for entity in entities:
            self._visit(entity)

    def _visit(self, entity) -> None:
        if not hasattr(entity, 'visit'):
            raise RuntimeError(f"expected a launch entity, got '{entity!r}'")
        following = entity.visit(self._context)
        future = entity.get_asyncio_future()
        if future is not None:
            self._context.add_future(future)
        self._visit_all(following or [])

    # --- failures and the end ---------------------------------------------------------------------------------

    def _guarded(self, function, *args) -> None:
        try:
            function(*args)
        except Exception as error:
            self._fail(error)

    def _fail(self, error: BaseException) -> None:
        self._logger.debug(''.join(traceback.format_exception(type(error), error, error.__traceback__)).rstrip())
        message = f'Caught exception in launch (see debug for traceback): {error}'
        self._logger.error(message)
        self._return_code = 1
        self._begin_shutdown(message)

    def _begin_shutdown(self, reason: str, *, due_to_sigint: bool = False) -> None:
        if not self._context.is_shutdown:
            self._context.is_shutdown = True
            self._context.emit_event_sync(Shutdown(reason=reason, due_to_sigint=due_to_sigint), urgent=True)

    def _catch_signals(self, loop: asyncio.AbstractEventLoop) -> dict:
        """Take the signals over, if this is the main thread; return the handlers to put back."""
        if threading.current_thread() is not threading.main_thread():
            return {}
        numbers = [signal.SIGINT, *(signal.Signals[name] for name in _STOPPING_SIGNALS)]
        previous = {number: signal.getsignal(number) for number in numbers}
        loop.add_signal_handler(signal.SIGINT, self._on_sigint)
        for number in numbers[1:]:
            loop.add_signal_handler(number, self._on_stopping_signal, number.name)
        return previous

    def _on_sigint(self) -> None:
        message = 'user interrupted with ctrl-c (SIGINT)'
        if self._interrupted:
            self._logger.warning(f'{message} again, ignoring...')
            return
        self._interrupted = True
        self._logger.warning(message)
        self._begin_shutdown('ctrl-c (SIGINT)', due_to_sigint=True)

    def _on_stopping_signal(self, name: str) -> None:
        self._logger.error(f'received {name}, ending all processes')
        self._return_code = 1
        self._begin_shutdown(name)

    async def _kill_rest(self) -> None:
        """Leave no process behind, whatever went wrong in the loop."""
        for process in list(self._context.running_processes):
            process.send_signal(signal.SIGKILL)
        if self._context._futures:
            await asyncio.wait(self._context._futures, timeout=5.0)
