"""Spinning nodes in the background of a kernel: one executor in one thread, nodes side by side."""

import ctypes
import inspect
import threading
import time

from helpers import nodes as node_list
from helpers.errors import Failure, raise_failures, say
from helpers.executors import StopCallback, Watch, running_here

_JOIN_SLICE = 0.1  # s
_handles: list['Spinning'] = []


def spinning(*nodes, executor=None) -> 'Spinning':
    """Spin nodes in the background, side by side, until the block ends or the handle is stopped.

    ::

        with spinning(talker, listener):
            wait_for(lambda: listener.count >= 3)

        handle = spinning(talker)     # goes on after the cell
        handle.stop()

    A node that is already spinning moves to the new handle; a node of the same name that is spinning is stopped and
    destroyed first, so the cell can be run again. The end of the block (or ``stop()``) joins the thread and destroys
    the nodes.

    :param nodes: living nodes of one context.
    :param executor: ``SingleThreadedExecutor`` (default), ``MultiThreadedExecutor``, or an executor object of your own,
        which is shut down at the end.
    :raises TypeError: an argument is not a node.
    :raises ValueError: no node, a destroyed node, or nodes of different contexts.
    """
    from rclpy.executors import Executor, SingleThreadedExecutor

    _check(nodes)
    names = {node_list.full_name(node) for node in nodes}
    for handle in list(_handles):
        for other in handle.nodes:
            if any(other is node for node in nodes):
                handle._let_go(other)
            elif other.context is nodes[0].context and node_list.full_name(other) in names:
                node_list.destroy(other)
    make = SingleThreadedExecutor if executor is None else executor
    made = make if isinstance(make, Executor) else make(context=nodes[0].context)
    if getattr(made, '_is_shutdown', False):
        raise ValueError('this executor has been shut down: create a new one, or pass its class')
    return Spinning(nodes, made)


class Spinning:
    """Handle of nodes that spin in the background; made by `spinning`."""

    def __init__(self, nodes, executor):
        self._nodes = list(dict.fromkeys(nodes))
        self._executor = executor
        self._watch = Watch(executor, self._note)
        self._failures: list[Failure] = []  # shown, not raised yet
        self._signal = _StopSignal()
        self._thread: threading.Thread | None = None
        self._ended = False
        _handles.append(self)
        for node in self._nodes:
            executor.add_node(node)
        self._start()

    @property
    def nodes(self) -> tuple:
        """The nodes that this handle spins and that are not destroyed."""
        return tuple(node for node in self._nodes if node_list.is_alive(node))

    @property
    def running(self) -> bool:
        """Whether the background thread runs."""
        return self._thread is not None and self._thread.is_alive()

    def check(self) -> None:
        """Raise CallbackError if a callback has raised since the last check or wait."""
        __tracebackhide__ = True
        failures, self._failures = self._failures, []
        raise_failures(failures)

    def stop(self, timeout: float = 5.0) -> None:
        """Stop spinning, join the thread and destroy the nodes; idempotent.

        :param timeout: seconds to wait for callbacks that are running. A callback that has not returned by then is
            interrupted by an exception; if even that does not end it (it waits inside a C function), it is named on
            stderr and left behind.
        """
        if self._ended:
            return
        self._halt(timeout)
        self._finish()
        for node in self.nodes:
            node_list.destroy(node)
        self._nodes.clear()
        self._failures.clear()

    def __enter__(self) -> 'Spinning':
        return self

    def __exit__(self, kind, error, tb) -> None:
        __tracebackhide__ = True
        failures = self._failures
        self._failures = []
        self.stop()
        if error is None:
            raise_failures(failures)

    def __repr__(self) -> str:
        state = 'spinning' if self.running else 'stopped'
        return f'<{state}: {", ".join(node_list.full_name(node) for node in self.nodes) or "no node"}>'

    def _start(self) -> None:
        self._signal = _StopSignal()
        names = ', '.join(node.get_name() for node in self._nodes)
        self._thread = threading.Thread(target=self._run, args=(self._signal,), daemon=True, name=f'spinning {names}')
        self._thread.start()

    def _run(self, signal: '_StopSignal') -> None:
        """The background thread. It blocks in rcl_wait while nothing happens, and ends with the signal or the context."""
        from rclpy.executors import ExternalShutdownException

        executor, context = self._executor, self._executor.context
        self._watch.spinner = threading.get_ident()
        trouble = 0
        while not signal.done() and context.ok():
            try:
                executor.spin_once_until_future_complete(signal, None)
                trouble = 0
            except (ExternalShutdownException, StopCallback):
                pass
            except Exception as error:  # from waiting, not from a callback: mostly a node destroyed under the wait
                self._drop_destroyed()
                trouble += 1
                if trouble >= 100:
                    self._note(Failure(str(self), 'the executor', error))
                    return

    def _drop_destroyed(self) -> None:
        for node in self._executor.get_nodes():
            if not node_list.is_alive(node):
                self._watch.release(node)

    def _note(self, failure: Failure) -> None:
        """Show a failure; the same one again is only counted until it has been raised."""
        for known in self._failures:
            if known.place == failure.place:
                known.times += 1
                return
        self._failures.append(failure)
        failure.show()

    def _halt(self, timeout: float) -> None:
        """End the background thread, and with it all callbacks; the nodes stay."""
        self._signal.set()
        self._executor.wake()
        mine = [self._thread] if self._thread else []
        if self._watch.pool and self._signal.done():
            # The worker threads have no work left once the spinning thread has ended and no callback runs.
            pass
        deadline = time.monotonic() + timeout
        self._wait_until_idle(mine, deadline)
        stuck = self._stuck(mine)
        if stuck:
            for work_thread in stuck:
                _throw(work_thread, StopCallback)
            self._wait_until_idle(mine, time.monotonic() + 1.0)
        for work in self._watch.running():
            if work is not running_here():
                say(
                    f'{work.callback} of node {work.node_name} has not returned for {work.seconds:.0f} s and cannot be '
                    'interrupted; its thread is left behind until the kernel restarts.\n'
                )

    def _wait_until_idle(self, threads, deadline: float) -> None:
        me = threading.current_thread()
        for thread in threads:
            while thread is not me and thread.is_alive() and time.monotonic() < deadline:
                thread.join(_JOIN_SLICE)
        pool = self._watch.pool.threads if self._watch.pool else []
        while time.monotonic() < deadline and pool and any(w is not running_here() for w in self._watch.running()):
            pool[0].join(0.01)

    def _stuck(self, threads) -> list[int]:
        from helpers.executors import _running

        me = threading.get_ident()
        return [ident for ident, work in list(_running.items()) if work.watch is self._watch and ident != me]

    def _finish(self) -> None:
        """Shut the executor down; its thread has ended."""
        self._ended = True
        if self in _handles:
            _handles.remove(self)
        for node in self._executor.get_nodes():
            self._watch.release(node)
        self._watch.end()
        if self._watch.pool:
            self._watch.pool.shutdown()
            deadline = time.monotonic() + 1.0
            for thread in self._watch.pool.threads:
                if thread is not threading.current_thread():
                    thread.join(max(0.0, deadline - time.monotonic()))
        self._executor.shutdown(timeout_sec=0)

    def _let_go(self, node) -> None:
        """Stop spinning one node, which stays alive; the others go on."""
        if self._ended or not any(node is mine for mine in self._nodes):
            return
        inside = running_here() is not None and running_here().watch is self._watch
        if not inside:  # a callback of this executor cannot wait for its own end
            self._halt(5.0)
        self._watch.release(node)
        self._nodes = [mine for mine in self._nodes if mine is not node]
        if inside:
            return
        if self._nodes:
            self._start()
        else:
            self._finish()


class _StopSignal:
    """What the executor takes for a future: done once the handle is to stop. Nobody needs to be called back."""

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


def handles() -> list[Spinning]:
    """Return the handles that are not stopped."""
    return list(_handles)


def is_spinning(node) -> bool:
    """Tell whether a background thread spins this node."""
    return any(node is mine for handle in _handles if handle.running for mine in handle.nodes)


def raise_pending() -> None:
    """Raise what callbacks of any handle have raised since the last wait, as a CallbackError."""
    __tracebackhide__ = True
    failures = []
    for handle in list(_handles):
        failures += handle._failures
        handle._failures = []
    raise_failures(failures)


def stop_all(timeout: float = 5.0) -> None:
    """Stop every handle. ``timeout`` as in `Spinning.stop`, for each."""
    for handle in list(_handles):
        handle.stop(timeout)


def _release_destroyed(node) -> None:
    for handle in list(_handles):
        handle._let_go(node)


def _check(nodes) -> None:
    from rclpy.node import Node

    if not nodes:
        raise ValueError('spinning() needs at least one node')
    for node in nodes:
        if inspect.isclass(node) and issubclass(node, Node):
            raise TypeError(f'{node.__name__} is a class: create the node first, as in spinning({node.__name__}())')
        if not isinstance(node, Node):
            raise TypeError(f'spinning() takes nodes, not {type(node).__name__}')
        if not node_list.is_alive(node):
            raise ValueError(
                f'this {type(node).__name__} has been destroyed (the end of spinning() does that): '
                'run the cell that creates it again'
            )
        if not node.context.ok():
            raise ValueError('ROS has been shut down: run helpers.ros.start() and create the nodes again')
    if any(node.context is not nodes[0].context for node in nodes):
        raise ValueError('these nodes belong to different contexts; one executor can spin only nodes of one context')


def _throw(thread: int, kind: type) -> None:
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(kind))


node_list.before_destroy.append(_release_destroyed)
