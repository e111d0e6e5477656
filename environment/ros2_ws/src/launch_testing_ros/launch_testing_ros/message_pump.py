"""Runs the callbacks of a node while a test waits."""

from __future__ import annotations

import threading

from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

_PERIOD = 0.1  # seconds after which the thread looks whether it shall end
_LONGEST_CALLBACK = 5.0  # seconds that ``stop`` waits for a callback to return


class MessagePump:
    """
    Spins a node in a thread of its own, between ``start`` and ``stop``.

    :param node: the node; nobody else spins it meanwhile
    :param context: the node's context, if it is not the default one
    """

    def __init__(self, node: Node, context: Context | None = None):
        self._node, self._context = node, context
        self._stopping = threading.Event()
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        """
        Begin to spin.

        :raises RuntimeError: if it spins already
        """
        if self._thread is not None:
            raise RuntimeError('the message pump runs already')
        self._stopping.clear()
        self._thread = threading.Thread(target=self._spin, name='message_pump', daemon=True)
        self._thread.start()

    def _spin(self) -> None:
        executor = SingleThreadedExecutor(context=self._context)
        executor.add_node(self._node)
        try:
            while not self._stopping.is_set():
                executor.spin_once(timeout_sec=_PERIOD)
        finally:
            executor.remove_node(self._node)
            executor.shutdown()

    def stop(self) -> None:
        """
        Stop spinning.

        :raises RuntimeError: if a callback does not return
        """
        thread, self._thread = self._thread, None
        if thread is None:
            return
        self._stopping.set()
        thread.join(_LONGEST_CALLBACK)
        if thread.is_alive():
            raise RuntimeError(f'the message pump does not stop: a callback runs for more than {_LONGEST_CALLBACK:g} s')
