"""Watches an rclpy executor: what its callbacks raise, which of them runs, and which other code tries to spin it.

Written for rclpy 7.1.6 as well as 7.1.9 and later: every executor takes its work from ``wait_for_ready_callbacks``, and
another executor that wants a node calls ``remove_node``.
"""

import queue
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

from helpers.kernel.callback_errors import Failure, learners_part
from helpers.kernel.nodes import is_doomed

#: Notified after every callback of a watched executor, so that waits react at once.
activity = threading.Condition()

#: Called with 'begin' or 'finish' and the `Work`, in its thread (see `helpers.show.timeline`).
observers: list = []

_TAKE = 0.05  # s; while all threads are busy, the longest time between two looks for new work
_running: dict[int, 'Work'] = {}  # thread -> the callback that a watched executor runs there
_KINDS = {
    'ActionClient': 'action client',
    'ActionServer': 'action server',
    'EventHandler': 'QoS event callback',
    'GuardCondition': 'guard condition callback',
    'NoneType': 'task',
    'Timer': 'timer callback',
}


class StopCallback(BaseException):
    """Thrown into a callback that does not return although its node is being stopped."""


class StopSignal:
    """Looks like a future to an executor: done once spinning is to stop. It calls no done-callbacks."""

    def __init__(self):
        self._set = False

    def set(self) -> None:
        self._set = True

    def done(self) -> bool:
        return self._set

    def cancelled(self) -> bool:
        return False

    def add_done_callback(self, callback) -> None:
        pass


class ExecutorWatch:
    """Watches one executor, and makes sure that only the thread ``spinner`` spins it.

    :param on_failure: called with a `Failure` in the thread in which a callback has raised.
    """

    def __init__(self, executor, on_failure):
        self.executor = executor
        self.on_failure = on_failure
        self.spinner: int | None = None
        self.pool = _replace_pool(executor)
        self._wait_for_ready_callbacks = executor.wait_for_ready_callbacks
        self._remove_node = executor.remove_node
        executor.wait_for_ready_callbacks = self._next_work
        executor.remove_node = self._refuse_remove

    def release(self, node) -> None:
        """Let go of a node."""
        self._remove_node(node)

    def end(self) -> None:
        """Give the executor back as it was."""
        for name in ('wait_for_ready_callbacks', 'remove_node'):
            vars(self.executor).pop(name, None)

    def busy(self) -> bool:
        """Tell whether callbacks run, or wait for a worker thread."""
        waiting = self.pool.pending if self.pool else 0
        work = running_here()
        return bool(self.running()) or waiting > (work is not None and work.watch is self)

    def running(self) -> list['Work']:
        """Return the callbacks that run now, except one that the caller itself is in."""
        return [w for thread, w in _running.copy().items() if w.watch is self and thread != threading.get_ident()]

    def _next_work(self, *args, **kwargs):
        if threading.get_ident() != self.spinner or running_here():
            raise RuntimeError(_refusal(self.executor.get_nodes()))
        if self.pool:  # rclpy hands out a task again and again until a thread has begun it
            self.pool.wait_until_taken(_TAKE)
        task, entity, node = self._wait_for_ready_callbacks(*args, **kwargs)
        return Work(self, task, entity, node), entity, node

    def _refuse_remove(self, node) -> None:
        """Another executor wants a node of this one: rclpy.spin_once(node) and its like would silently take it away."""
        if node not in self.executor.get_nodes():
            return
        frame = sys._getframe(1)
        while frame is not None:
            if frame.f_code.co_name == 'add_node':
                frame.f_locals['self'].remove_node(node)  # it has already noted the node as its own
                break
            frame = frame.f_back
        raise RuntimeError(_refusal([node]))


class Work:
    """Stands for the task that rclpy hands out: runs it, and reports what it raises instead of passing it on."""

    def __init__(self, watch: ExecutorWatch, task, entity, node):
        self.watch = watch
        self.task = task
        self.entity = entity
        self.node = node
        self.thread = 0
        self.since = 0.0

    def __call__(self):
        self.thread = threading.get_ident()
        self.since = time.monotonic()
        _running[self.thread] = self
        for observe in observers:
            observe('begin', self)
        error = None
        try:
            self.task()
            if self.task.done():
                error = self.task.exception()
        except StopCallback:
            self.task.cancel()
        except KeyboardInterrupt:  # the stop button, while spin_for() spins in the main thread
            self.task.cancel()
            raise
        except BaseException as left:  # exit() in a callback must not end the executor's thread
            self.task.cancel()
            error = left
        finally:
            for observe in observers:
                observe('finish', self)
            _running.pop(self.thread, None)
        if error is not None and not self._died_with_its_node(error):
            self.watch.on_failure(Failure(self.node_name, self.describe(error), error))
        with activity:
            activity.notify_all()

    def __getattr__(self, name):
        return getattr(self.task, name)

    def done(self) -> bool:
        """Tell whether it will not run any more; a task that was cancelled does not say so, and would be kept."""
        return self.task.done() or self.task.cancelled()

    def exception(self):
        """Return None: the executor asks after the run, to raise it in the thread that spins."""
        return

    def result(self):
        """Return None, as `exception` does."""
        return

    def _died_with_its_node(self, error: BaseException) -> bool:
        """Tell whether the node was being destroyed while the callback ran: then the error is not the callback's."""
        from rclpy.exceptions import InvalidHandle

        return isinstance(error, InvalidHandle) and self.node is not None and is_doomed(self.node)

    @property
    def seconds(self) -> float:
        """How long the callback has been running, in seconds."""
        return time.monotonic() - self.since

    @property
    def node_name(self) -> str:
        """The name of the callback's node; of all the executor's nodes, if it is nobody's in particular."""
        nodes = self.watch.executor.get_nodes() if self.node is None else [self.node]
        return ' or '.join(sorted(node.get_name() for node in nodes)) or '?'

    def describe(self, error: BaseException | None = None) -> str:
        """Name the callback, such as ``timer callback Talker.tick``; one without a name of its own after ``error``."""
        kind = _KINDS.get(type(self.entity).__name__, type(self.entity).__name__.lower())
        if hasattr(self.entity, 'topic_name'):
            kind = f'subscription callback on {self.entity.topic_name!r}'
        elif hasattr(self.entity, 'srv_name'):
            kind = f'{kind} callback of {self.entity.srv_name!r}'
        function = getattr(self.entity, 'callback', None)
        name = getattr(getattr(function, 'func', function), '__qualname__', '')
        if not name and error is not None and error.__traceback__ is not None:
            code = learners_part(error.__traceback__).tb_frame.f_code
            name = getattr(code, 'co_qualname', code.co_name)  # co_qualname: Python >= 3.11
        return f'{kind} {name.split("<locals>.")[-1]}'.rstrip()


def running_here() -> Work | None:
    """Return the callback in which the calling code runs, or None."""
    return _running.get(threading.get_ident())


def refuse_in_callback(what: str) -> None:
    """Raise RuntimeError if the caller is in a callback of a watched executor, where waiting stops all callbacks."""
    __tracebackhide__ = True
    work = running_here()
    if work:
        raise RuntimeError(
            f'{what} was called inside the {work.describe()} of node {work.node_name}, where waiting stops the other '
            'callbacks: return, and let a timer or another callback go on later'
        )


def _refusal(nodes) -> str:
    names = ', '.join(sorted(node.get_name() for node in nodes)) or 'it'
    work = running_here()
    if work:
        return (
            f'{_spin_call()} was called inside the {work.describe()} of node {work.node_name}, but {names} is already '
            'being spun. Do not spin in a callback: make it `async def` and `await` the future, or use '
            'future.add_done_callback().'
        )
    return (
        f'{_spin_call()} was called, but {names} already spins in the background. Wait with wait_for() or spin_for(), '
        'or stop the background spinning first.'
    )


def _spin_call() -> str:
    """Name the spin function that the calling code used, as it is written in a program."""
    found = 'spin()'
    frame = sys._getframe(1)
    while frame is not None and frame.f_code is not Work.__call__.__code__:  # below it, rclpy spins as it should
        module, function = frame.f_globals.get('__name__'), frame.f_code.co_name
        if module == 'rclpy' and function.startswith('spin'):
            return f'rclpy.{function}()'
        if module == 'rclpy.executors' and function.startswith(('spin', 'add_node')):
            found = f'executor.{function}()'
        frame = frame.f_back
    return found


class DaemonPool:
    """Worker threads for a MultiThreadedExecutor that never keep the interpreter from exiting.

    The threads of ``concurrent.futures`` do, and rclpy 7.1.6 does not end them: one callback that never returns would
    hang every exit and every kernel restart.
    """

    def __init__(self, size: int):
        self.size = size
        self.threads: list[threading.Thread] = []
        self.pending = 0  # work that waits or runs
        self._queue: queue.SimpleQueue = queue.SimpleQueue()
        self._waiting = 0  # work that no thread has taken
        self._taken = threading.Condition()
        self._stopped = False

    def submit(self, work) -> None:
        """Run ``work()`` in one of the threads."""
        if self._stopped:
            return
        with activity:
            self.pending += 1
        with self._taken:
            self._waiting += 1
        self._queue.put(work)
        if len(self.threads) < self.size:
            thread = threading.Thread(target=self._run, daemon=True, name=f'callbacks {len(self.threads) + 1}')
            self.threads.append(thread)
            thread.start()

    def wait_until_taken(self, timeout: float) -> bool:
        """Wait until threads have taken all work, at most ``timeout`` seconds; tell whether they have."""
        with self._taken:
            return self._taken.wait_for(lambda: not self._waiting, timeout)

    def shutdown(self, wait: bool = False, timeout: float = 1.0) -> None:
        """Tell the threads to end after the work that they have.

        :param wait: wait for them, at most ``timeout`` seconds.
        """
        self._stopped = True
        for _ in self.threads:
            self._queue.put(None)  # behind the work
        deadline = time.monotonic() + (timeout if wait else 0.0)
        for thread in self.threads:
            if thread is not threading.current_thread():
                thread.join(max(0.0, deadline - time.monotonic()))

    def _run(self) -> None:
        while True:
            try:
                work = self._queue.get()
                if work is None:
                    return
                with self._taken:
                    self._waiting -= 1
                    self._taken.notify_all()
                try:
                    work()
                finally:
                    with activity:
                        self.pending -= 1
                        activity.notify_all()
            except StopCallback:  # the exception came late: the callback for which it was thrown had just returned
                pass


def _replace_pool(executor) -> DaemonPool | None:
    pool = getattr(executor, '_executor', None)
    if isinstance(pool, ThreadPoolExecutor):
        executor._executor = DaemonPool(pool._max_workers)
        pool.shutdown(wait=False)
    return executor._executor if isinstance(pool, (DaemonPool, ThreadPoolExecutor)) else None
