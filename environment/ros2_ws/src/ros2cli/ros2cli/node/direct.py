"""A node for the time of one command, in a context of its own."""

import argparse
import os
import signal
import threading
import time
from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.action import (
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.signals import SignalHandlerOptions

from ros2cli.node import NODE_NAME_PREFIX
from ros2cli.node.arguments import add_direct_arguments as add_arguments
from ros2cli.node.discovery import wait_for_graph

__all__ = ['DEFAULT_TIMEOUT', 'DirectNode', 'add_arguments']

DEFAULT_TIMEOUT = None  # what --spin-time is if it is not given: until the graph is known

# Seconds after which a wait looks whether Ctrl+C was pressed.
_LONGEST_WAIT = 0.1


class DirectNode:
    """
    A context manager that gives a node which knows the graph; what it does not have itself, the node has.

    Ctrl+C raises KeyboardInterrupt while the context is still valid, so that a goal can be cancelled; SIGTERM ends
    the process with status 143 after the node has left the graph.
    """

    def __init__(self, args: argparse.Namespace | None, *, node_name: str | None = None, discover: bool = True):
        """
        Create the node.

        :param args: the parsed arguments; `spin_time` (seconds) and `use_sim_time` are used if they are there.
        :param node_name: its name; a hidden one of its own if none is given.
        :param discover: wait for the graph.
        """
        use_sim_time = getattr(args, 'use_sim_time', False)
        spin_time = getattr(args, 'spin_time', None)
        # rclpy's own handlers would make the context invalid before this program can leave the graph in order.
        rclpy.init(args=[], signal_handler_options=SignalHandlerOptions.NO)
        self._spinning = False
        self._pending: BaseException | None = None
        # Python lets only the main thread handle signals. In another one, who started it has to end it.
        handled = (signal.SIGINT, signal.SIGTERM) if threading.current_thread() is threading.main_thread() else ()
        self._old_handlers = {number: signal.signal(number, self._stop) for number in handled}
        self.node = rclpy.create_node(
            node_name or f'{NODE_NAME_PREFIX}_{os.getpid()}',
            start_parameter_services=False,
            parameter_overrides=[Parameter('use_sim_time', value=use_sim_time)],
        )
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        try:
            if spin_time is not None:
                self.spin(lambda: False, timeout=spin_time)
            elif discover:
                wait_for_graph(self.node)
        except BaseException:
            self.__exit__()
            raise

    def __enter__(self) -> 'DirectNode':
        """Return the node."""
        return self

    def __exit__(self, *_: Any) -> None:
        """Leave the graph; a second Ctrl+C does not interrupt that."""
        for number in self._old_handlers:
            signal.signal(number, signal.SIG_IGN)
        try:
            self.executor.shutdown(timeout_sec=1.0)
            self.node.destroy_node()
            rclpy.try_shutdown()
        finally:
            for number, handler in self._old_handlers.items():
                signal.signal(number, handler)

    def __getattr__(self, name: str) -> Any:
        """Pass everything else on to the rclpy node."""
        if name == 'node':  # not created: do not look for it in itself
            raise AttributeError(name)
        return getattr(self.node, name)

    def spin(self, until: Callable[[], bool] = lambda: False, timeout: float | None = None) -> bool:
        """Run callbacks until the condition holds; return False if `timeout` seconds pass first."""
        deadline = None if timeout is None else time.monotonic() + timeout
        while not until():
            wait = _LONGEST_WAIT if deadline is None else min(_LONGEST_WAIT, deadline - time.monotonic())
            if wait <= 0:
                return False
            self._spinning = True
            try:
                self.executor.spin_once(timeout_sec=wait)
            finally:
                self._spinning = False
            if self._pending is not None:
                pending, self._pending = self._pending, None
                raise pending
        return True

    def _stop(self, signum: int, _: Any) -> None:
        """Handle Ctrl+C and SIGTERM: a callback that runs is finished first, but not for a second signal."""
        end = KeyboardInterrupt() if signum == signal.SIGINT else SystemExit(128 + signum)
        if not self._spinning or self._pending is not None:
            raise end
        self._pending = end

    def wait_for(self, future: Any, timeout: float | None = None) -> Any:
        """
        Run callbacks until the future is done and return its result.

        :raises TimeoutError: if that takes longer than `timeout` seconds.
        """
        if not self.spin(future.done, timeout):
            raise TimeoutError(f'no answer within {timeout} s')
        return future.result()

    def get_action_names_and_types(self) -> Any:
        """Return all actions with their types."""
        return get_action_names_and_types(self.node)

    def get_action_client_names_and_types_by_node(self, name: str, namespace: str) -> Any:
        """Return the actions that a node is a client of, with their types."""
        return get_action_client_names_and_types_by_node(self.node, name, namespace)

    def get_action_server_names_and_types_by_node(self, name: str, namespace: str) -> Any:
        """Return the actions that a node serves, with their types."""
        return get_action_server_names_and_types_by_node(self.node, name, namespace)
