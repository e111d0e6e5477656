"""Watching an rclpy executor: what its callbacks raise, which of them runs, and who else tries to spin it.

Works on the public surface of rclpy (7.1.6 to 7.1.9 and later): every executor takes its work from
``wait_for_ready_callbacks``, and a node changes its executor through ``remove_node``.
"""

import queue
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial

from helpers.errors import Failure

#: Notified after every callback of a watched executor, so that waits react at once.
activity = threading.Condition()

# Thread -> the callback that a watched executor runs there.
_running: dict[int, '_Work'] = {}


class StopCallback(BaseException):
    """Thrown into a callback that does not return although its node is being stopped."""


def running_here() -> '_Work | None':
    """Return the callback in which the calling code runs, or None."""
    return _running.get(threading.get_ident())


def refuse_in_callback(what: str) -> None:
    """Raise RuntimeError if the caller is inside a callback of a watched executor, where waiting stops all callbacks."""
    __tracebackhide__ = True
    work = running_here()
    if work:
        raise RuntimeError(
            f'{what} was called inside {work.callback} of node {work.node_name}: the executor cannot run other callbacks '
            'meanwhile. Return from the callback; let a timer or another callback go on later.'
        )


class Watch:
    """Watches one executor.

    :param on_failure: called in the executor's thread with each new `Failure`.
    """

    def __init__(self, executor, on_failure):
        self.executor = executor
        self.on_failure = on_failure
        self.spinner: int | None = None  # the thread that may take work
        self._inner_wait = executor.wait_for_ready_callbacks
        self._inner_remove = executor.remove_node
        executor.wait_for_ready_callbacks = self._wait_for_ready_callbacks
        executor.remove_node = self._refuse_remove
        self.pool = _replace_pool(executor)

    def release(self, node) -> None:
        """Let go of a node."""
        self._inner_remove(node)

    def end(self) -> None:
        """Give the executor back as it was."""
        for name in ('wait_for_ready_callbacks', 'remove_node'):
            self.executor.__dict__.pop(name, None)

    def running(self) -> list['_Work']:
        """Return the callbacks that this executor runs now, longest first."""
        mine = [work for work in list(_running.values()) if work.watch is self]
        return sorted(mine, key=lambda work: work.since)

    def _wait_for_ready_callbacks(self, *args, **kwargs):
        if threading.get_ident() != self.spinner or running_here():
            raise RuntimeError(self._refusal(self.executor.get_nodes()))
        task, entity, node = self._inner_wait(*args, **kwargs)
        return _Work(self, task, entity, node), entity, node

    def _refuse_remove(self, node) -> None:
        """Another executor wants a node of this one: rclpy.spin_once(node) and its like would silently take it away."""
        if node not in self.executor.get_nodes():
            return
        frame = sys._getframe(1)
        while frame is not None:
            other = frame.f_locals.get('self')
            if frame.f_code.co_name == 'add_node' and other is not self.executor:
                other.remove_node(node)  # it has already noted the node as its own
                break
            frame = frame.f_back
        raise RuntimeError(self._refusal([node]))

    def _refusal(self, nodes) -> str:
        names = ', '.join(sorted(node.get_name() for node in nodes)) or 'no node'
        call = _spin_call()
        work = running_here()
        if work:
            return (
                f'{call} was called inside {work.callback} of node {work.node_name}, but {names} is already spun by '
                'spinning(). Do not spin inside a callback: make it `async def` and `await` the future, or use '
                'future.add_done_callback(...).'
            )
        return (
            f'{call} was called on {names}, which spinning() already spins in the background. Use wait_for(...) or '
            'spin_for(seconds) to wait, or stop the background spinning first.'
        )


class _Work:
    """Stands for the task that rclpy hands out: runs it, keeps what it raises away from the executor, and reports it."""

    def __init__(self, watch: Watch, task, entity, node):
        self.watch = watch
        self.task = task
        self.entity = entity
        self.node = node
        self.since = 0.0

    def __call__(self):
        thread = threading.get_ident()
        self.since = time.monotonic()
        outer = _running.get(thread)
        _running[thread] = self
        error = None
        try:
            self.task()
            if self.task.done():
                error = self.task.exception()
        except StopCallback:
            self.task.cancel()
        except KeyboardInterrupt:
            self.task.cancel()
            raise
        except BaseException as stopped:  # exit() and sys.exit() in a callback must not end the executor's thread
            self.task.cancel()
            error = stopped
        finally:
            if outer is None:
                _running.pop(thread, None)
            else:
                _running[thread] = outer
        if error is not None and not isinstance(error, StopCallback):
            self.watch.on_failure(Failure(self.node_name, self.describe(error), error))
        with activity:
            activity.notify_all()

    def __getattr__(self, name):
        return getattr(self.task, name)

    # The executor asks for these after the run, to raise them in the thread that spins.
    def exception(self):
        return None

    def result(self):
        return None

    @property
    def seconds(self) -> float:
        """How long the callback has been running, in seconds."""
        return time.monotonic() - self.since

    @property
    def node_name(self) -> str:
        if self.node is not None:
            return self.node.get_name()
        return ', '.join(sorted(node.get_name() for node in self.watch.executor.get_nodes())) or '?'

    @property
    def callback(self) -> str:
        return self.describe(None)

    def describe(self, error) -> str:
        """Name the callback, such as ``timer callback Talker.tick``."""
        kind, function = _kind_and_function(self.entity)
        name = getattr(function, '__qualname__', None)
        if name is None and isinstance(function, partial):
            name = function.func.__qualname__
        if name is None and error is not None and error.__traceback__ is not None:
            tb = Failure('', '', error).error.__traceback__
            name = getattr(tb.tb_frame.f_code, 'co_qualname', tb.tb_frame.f_code.co_name)
        return f'{kind} {name.replace("<locals>.", "")}' if name else kind


def _kind_and_function(entity):
    function = getattr(entity, 'callback', None)
    if entity is None:
        return 'task', None
    kind = type(entity).__name__.lower()
    if hasattr(entity, 'topic_name') and function:
        return f'subscription {entity.topic_name!r} callback', function
    if hasattr(entity, 'srv_name'):
        return f'{kind} {entity.srv_name!r} callback', function
    return f'{kind} callback', function


def _spin_call() -> str:
    """Name the spin function that the calling code used, as it is written in a program."""
    frame = sys._getframe(1)
    found = 'spin'
    while frame is not None:
        module = frame.f_globals.get('__name__', '')
        if module in ('rclpy', 'rclpy.executors') and frame.f_code.co_name.startswith(('spin', 'add_node')):
            found = f'rclpy.{frame.f_code.co_name}' if module == 'rclpy' else f'executor.{frame.f_code.co_name}'
        frame = frame.f_back
    return f'{found}()'


class DaemonPool:
    """Worker threads for a MultiThreadedExecutor that never keep the interpreter from exiting.

    The threads of ``concurrent.futures`` do, and rclpy does not end them: one callback that never returns would hang
    every exit and every kernel restart.
    """

    def __init__(self, size: int):
        self.size = size
        self.threads: list[threading.Thread] = []
        self._queue: queue.SimpleQueue = queue.SimpleQueue()
        self._stopped = False

    def submit(self, work) -> None:
        """Run ``work()`` in one of the threads."""
        if self._stopped:
            return
        self._queue.put(work)
        if len(self.threads) < self.size:
            thread = threading.Thread(target=self._run, daemon=True, name=f'callbacks {len(self.threads) + 1}')
            self.threads.append(thread)
            thread.start()

    def shutdown(self, wait: bool = False) -> None:
        """Tell the threads to end after the work that they have; does not wait for them."""
        self._stopped = True
        for _ in self.threads:
            self._queue.put(None)

    def _run(self) -> None:
        while (work := self._queue.get()) is not None:
            try:
                work()
            except StopCallback:
                pass


def _replace_pool(executor) -> DaemonPool | None:
    pool = getattr(executor, '_executor', None)
    if isinstance(pool, DaemonPool):
        return pool
    if not isinstance(pool, ThreadPoolExecutor):
        return None
    executor._executor = DaemonPool(pool._max_workers)
    pool.shutdown(wait=False)
    return executor._executor
