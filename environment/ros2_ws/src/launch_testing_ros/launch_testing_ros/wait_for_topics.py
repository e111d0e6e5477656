"""Waits for messages."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node


class WaitForTopics:
    """
    Waits until a message has come on each of some topics; made, it has a node of its own, until ``shutdown``.

    As a context manager it waits at the beginning, and shuts down at the end.

    :param topic_tuples: (name, type) pairs
    :param timeout: seconds
    :param messages_received_buffer_length: how many messages of each topic are kept
    :param node_namespace: the namespace of the node
    :param trigger: a function of the node, called once the node listens
    """

    def __init__(
        self,
        topic_tuples: Iterable[tuple[str, type]],
        timeout: float = 5.0,
        messages_received_buffer_length: int | None = 10,
        node_namespace: str | None = None,
        trigger: Callable[[Node], None] | None = None,
    ):
        self.topic_tuples, self.timeout, self.trigger = list(topic_tuples), timeout, trigger
        self._received: dict[str, deque] = {
            name: deque(maxlen=messages_received_buffer_length) for name, _ in self.topic_tuples
        }
        self._changed = threading.Condition()
        self._context = rclpy.Context()
        rclpy.init(context=self._context)
        self._node = Node('wait_for_topics', context=self._context, namespace=node_namespace)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self._stopping = False
        self._is_listening = False
        self._thread = threading.Thread(target=self._spin, name='wait_for_topics', daemon=True)
        self._thread.start()

    def _spin(self) -> None:
        while not self._stopping:
            self._executor.spin_once(timeout_sec=1.0)

    def wait(self) -> bool:
        """Return True when each topic has had a message; False if that does not happen in time."""
        if not self._is_listening:
            self._is_listening = True
            for name, kind in self.topic_tuples:
                self._node.create_subscription(kind, name, self._keeper(name), 10)
        if self.trigger is not None:
            self.trigger(self._node)
        with self._changed:
            return self._changed.wait_for(lambda: not self.topics_not_received(), self.timeout)

    def _keeper(self, name: str) -> Callable[[object], None]:
        def keep(message: object) -> None:
            with self._changed:
                self._received[name].append(message)
                self._changed.notify_all()

        return keep

    def topics_received(self) -> set[str]:
        """Return the topics that have had a message."""
        return {name for name, messages in self._received.items() if messages}

    def topics_not_received(self) -> set[str]:
        """Return the topics that have not had a message."""
        return {name for name, messages in self._received.items() if not messages}

    def received_messages(self, topic_name: str) -> list:
        """
        Return the last messages of a topic, the newest at the end.

        :raises KeyError: if it is none of the topics
        """
        with self._changed:
            return list(self._received[topic_name])

    def shutdown(self) -> None:
        """Leave the graph."""
        self._stopping = True
        self._executor.wake()
        self._thread.join()
        self._executor.shutdown()
        self._node.destroy_node()
        self._context.try_shutdown()

    def __enter__(self) -> WaitForTopics:
        if not self.wait():
            missing = self.topics_not_received()
            self.shutdown()
            raise RuntimeError('Did not receive messages on these topics: ', missing)
        return self

    def __exit__(self, *_: object) -> None:
        self.shutdown()
