"""Spinning nodes in the background of a kernel: one executor in one thread, nodes side by side."""

import ctypes
import inspect
import threading
import time

from helpers.kernel import nodes as node_list
from helpers.kernel.callback_errors import Failure, raise_failures, say
from helpers.kernel.executors import ExecutorWatch, StopCallback, StopSignal, activity, running_here
from helpers.kernel.handles import add, handles, remove

_JOIN_SLICE = 0.1  # s; a join without timeout could not be interrupted
_MOST_TROUBLE = 100  # exceptions of the executor itself, one after another, before its thread ends


def spinning(*nodes, executor=None) -> 'Spinning':
    """Spin nodes in the background, side by side, until the block ends or the handle is stopped.

    ::

        with spinning(talker, listener):
            wait_for(lambda: listener.count >= 3)

        handle = spinning(talker)     # goes on after the cell
        handle.stop()

    The end of the block, or ``stop()``, joins the thread and destroys the nodes. To run a cell again is safe: a node
    that already spins moves to the new handle; a spinning node of the same name is stopped and destroyed first.

    An exception in a callback is shown in the running cell, and all nodes go on; the next wait (or ``handle.check()``,
    or the end of the block) raises it as a CallbackError.

    :param nodes: living nodes of one context.
    :param executor: ``SingleThreadedExecutor`` (default), ``MultiThreadedExecutor``, or an executor object of your own,
        which is shut down at the end.
    :raises TypeError: an argument is not a node.
    :raises ValueError: no node, a destroyed node, nodes of different contexts, or an executor that was shut down.
    """
    from rclpy.executors import Executor, SingleThreadedExecutor

    from helpers import ros  # cleans up at the end of the process

    ros.tame_signals()
    _check(nodes)
    names = {node_list.full_name(node) for node in nodes}
    for handle in handles():
        for other in handle.nodes:
            if any(other is node for node in nodes):
                handle.let_go(other)
            elif other.context is nodes[0].context and node_list.full_name(other) in names:
                node_list.destroy(other)
    if not isinstance(executor, Executor):
        executor = (executor or SingleThreadedExecutor)(context=nodes[0].context)
    elif getattr(executor, '_is_shutdown', False):
        raise ValueError('this executor has been shut down: create a new one, or give its class')
    return Spinning(nodes, executor)


class Spinning:
    """Handle of nodes that spin in the background; made by `spinning`."""

    def __init__(self, nodes, executor):
        self._nodes = list(dict.fromkeys(nodes))
        self._executor = executor
        self._watch = ExecutorWatch(executor, self._note)
        self._failures: list[Failure] = []  # shown, but not raised yet
        self._signal = StopSignal()
        self._thread: threading.Thread | None = None
        self._ended = False
        add(self)
        for node in self._nodes:
            executor.add_node(node)
        self._start()

    @property
    def nodes(self) -> tuple:
        """The living nodes of this handle."""
        return tuple(node for node in self._nodes if node_list.is_alive(node))

    @property
    def running(self) -> bool:
        """Whether the background thread runs."""
        return self._thread is not None and self._thread.is_alive()

    def check(self) -> None:
        """Raise CallbackError if a callback has raised since the last check or wait."""
        __tracebackhide__ = True
        raise_failures(self.take_failures())

    def stop(self, timeout: float = 5.0) -> None:
        """Stop spinning, join the thread and destroy the nodes; idempotent.

        :param timeout: seconds to wait for callbacks that are running. One that has not returned by then is interrupted
            by an exception; if not even that ends it (it waits inside a C function), it is named on stderr and left.
        """
        if self._ended:
            return
        self._halt(timeout)
        mine = self.nodes
        self._finish()
        for node in mine:
            node_list.destroy(node)

    def let_go(self, node) -> None:
        """Stop spinning one node, which stays alive; the others go on."""
        if self._ended or not any(node is mine for mine in self._nodes):
            return
        work = running_here()
        inside = work is not None and work.watch is self._watch
        if not inside:  # a callback cannot wait until it has itself returned
            self._halt()
        self._watch.release(node)
        self._nodes = [mine for mine in self._nodes if mine is not node]
        if not self._nodes:
            self._finish()
        elif not inside:
            self._start()

    def take_failures(self) -> list[Failure]:
        """Return what callbacks have raised since the last time, and forget it."""
        taken = []
        while self._failures:
            taken.append(self._failures.pop(0))
        return taken

    def stuck(self, seconds: float = 1.0) -> list[str]:
        """Return a sentence for each callback that has been running for longer than ``seconds``."""
        return [
            f'the {work.describe()} of node {work.node_name} has been running for {work.seconds:.1f} s'
            for work in self._watch.running()
            if work.seconds > seconds
        ]

    def pass_round(self, timeout: float, busy: float) -> None:
        """Wait until the callbacks that are ready now have run: until the executor has begun two more rounds.

        :param timeout: seconds to wait at most.
        :param busy: seconds to wait at most for callbacks that run in other threads.
        """
        deadline = time.monotonic() + timeout
        for _ in range(2):  # the first may belong to a round that had begun before
            passed = threading.Event()
            self._executor.create_task(passed.set)
            while not passed.wait(min(_JOIN_SLICE, max(0.0, deadline - time.monotonic()))):
                if not self.running or time.monotonic() >= deadline:
                    return
        with activity:
            activity.wait_for(lambda: not self._watch.busy(), max(0.0, min(busy, deadline - time.monotonic())))

    def __enter__(self) -> 'Spinning':
        return self

    def __exit__(self, kind, error, tb) -> None:
        __tracebackhide__ = True
        self.stop()
        if error is None:
            self.check()

    def __repr__(self) -> str:
        names = ', '.join(node_list.full_name(node) for node in self.nodes) or 'no node'
        return f'<{"spinning" if self.running else "stopped"}: {names}>'

    def _start(self) -> None:
        self._signal = StopSignal()
        name = f'spinning {", ".join(node.get_name() for node in self._nodes)}'
        self._thread = threading.Thread(target=self._run, args=(self._signal,), daemon=True, name=name)
        self._thread.start()

    def _run(self, signal: StopSignal) -> None:
        """The background thread: blocks in rcl_wait while nothing happens, and ends with the signal or the context."""
        from rclpy.executors import ExternalShutdownException

        self._watch.spinner = threading.get_ident()
        trouble = 0
        while not signal.done() and self._executor.context.ok() and trouble < _MOST_TROUBLE:
            try:
                self._executor.spin_once_until_future_complete(signal, None)
                trouble = 0
            except (ExternalShutdownException, StopCallback):
                pass
            except Exception as error:
                # The executor's own, not a callback's: usually a node was destroyed during the wait.
                trouble += 1
                self._drop_destroyed_nodes()
                if trouble == _MOST_TROUBLE:
                    self._note(Failure(repr(self), 'executor', error))

    def _drop_destroyed_nodes(self) -> None:
        for node in self._executor.get_nodes():
            if not node_list.is_alive(node):
                self._watch.release(node)

    def _note(self, failure: Failure) -> None:
        """Show a failure; a timer that raises at every tick counts as one failure until it has been raised."""
        for known in self._failures:
            if known.place == failure.place:
                known.times += 1
                known.show()
                return
        failure.show()
        self._failures.append(failure)  # after it is shown: a wait raises it from now on

    def _halt(self, timeout: float = 5.0) -> None:
        """End the background thread and all callbacks; the nodes stay in the executor."""
        self._signal.set()
        self._wait_for_end(timeout)
        for work in self._watch.running():
            _throw(work.thread, StopCallback)
        self._wait_for_end(1.0)
        for sentence in self.stuck(0.0):
            say(f'{sentence} and cannot be interrupted; its thread stays until the kernel restarts.\n')

    def _wait_for_end(self, timeout: float) -> None:
        """Wait for the thread, and for callbacks in worker threads, at most ``timeout`` seconds."""
        deadline = time.monotonic() + timeout
        if self._thread is not None and self._thread is not threading.current_thread():
            while self._thread.is_alive() and (left := deadline - time.monotonic()) > 0:
                self._executor.wake()
                self._thread.join(min(left, _JOIN_SLICE))
        with activity:
            activity.wait_for(lambda: not self._watch.busy(), max(0.0, deadline - time.monotonic()))

    def _finish(self) -> None:
        """Shut the executor down; its thread has ended, or is the one that calls this."""
        self._ended = True
        self._signal.set()
        remove(self)
        for node in self._executor.get_nodes():
            self._watch.release(node)
        self._nodes = []
        self._watch.end()
        if self._watch.pool:
            self._watch.pool.shutdown(wait=True)
        self._executor.shutdown(timeout_sec=0)


def _let_go_everywhere(node) -> None:
    for handle in handles():
        handle.let_go(node)


def _check(nodes) -> None:
    __tracebackhide__ = True
    from rclpy.node import Node

    if not nodes:
        raise ValueError('spinning() needs at least one node, as in spinning(talker)')
    for node in nodes:
        if inspect.isclass(node) and issubclass(node, Node):
            raise TypeError(f'{node.__name__} is a class: create the node first, as in spinning({node.__name__}())')
        if not isinstance(node, Node):
            raise TypeError(f'spinning() takes nodes, not {type(node).__name__}')
        if not node_list.is_alive(node):
            raise ValueError(
                f'this {type(node).__name__} has been destroyed (the end of its spinning does that): '
                'run the cell that creates it again'
            )
        if not node.context.ok():
            raise ValueError('ROS has been shut down: run helpers.ros.start() and create the nodes again')
        if node.context is not nodes[0].context:
            raise ValueError('these nodes belong to different contexts, but one executor spins nodes of one context')


def _throw(thread: int, kind: type) -> None:
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(kind))


node_list.before_destroy.append(_let_go_everywhere)
