"""Changes messages on their way from one topic to another."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.node import Node


class DataRepublisher:
    """
    Publishes the messages of a topic on another one, changed; until ``shutdown``.

    :param node: the node that subscribes and publishes; somebody else spins it
    :param listen_topic: the topic to hear
    :param publish_topic: the topic to publish on
    :param msg_type: the type of both
    :param transform_fn: returns what to publish for a message, or None to leave it out
    """

    def __init__(
        self, node: Node, listen_topic: str, publish_topic: str, msg_type: type, transform_fn: Callable[[Any], Any]
    ):
        self._node, self._transform, self._received = node, transform_fn, 0
        self._republished: list[Any] = []
        self._publisher = node.create_publisher(msg_type, publish_topic, 10)
        self._subscription = node.create_subscription(msg_type, listen_topic, self._pass_on, 10)

    def _pass_on(self, message: Any) -> None:
        self._received += 1
        changed = self._transform(message)
        if changed is not None:
            self._republished.append(changed)
            self._publisher.publish(changed)

    def get_num_received(self) -> int:
        """Return how many messages have come."""
        return self._received

    def get_num_republished(self) -> int:
        """Return how many messages have been published."""
        return len(self._republished)

    def get_republished(self) -> list[Any]:
        """Return the messages that have been published, in order."""
        return self._republished

    def shutdown(self) -> None:
        """Stop."""
        self._node.destroy_subscription(self._subscription)
        self._node.destroy_publisher(self._publisher)
