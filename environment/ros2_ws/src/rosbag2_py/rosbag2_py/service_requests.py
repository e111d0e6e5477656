"""Sends the requests of a service that a bag holds, in place of its events."""

import time
from collections.abc import Callable
from typing import Any

from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.serialization import deserialize_message
from rclpy.task import Future
from service_msgs.msg import ServiceEventInfo

# Each request may be in a bag twice: as the client sent it, and as the service received it.
SOURCES = {
    'service_introspection': ServiceEventInfo.REQUEST_RECEIVED,
    'client_introspection': ServiceEventInfo.REQUEST_SENT,
}
_PATIENCE = 1.0  # seconds for a service that is there to be found
_STEP = 0.05


class ServiceRequests:
    """
    A client of a service, to which a player hands the recorded events as to a publisher.

    :param kind: the class of the service
    :param source: whose requests to send, a key of `SOURCES`
    :param wait: spins the node for so many seconds
    """

    def __init__(self, node: Node, kind: Any, name: str, source: str, wait: Callable[[float], Any]):
        """Create the client, and look for the service."""
        self._node, self._name, self._wait = node, name, wait
        self._event, self._wanted = kind.Event, SOURCES[source]
        self._client = node.create_client(kind, name)
        self._client.wait_for_service(timeout_sec=_PATIENCE)
        self._awaited: list[Future] = []

    def publish(self, data: bytes) -> None:
        """Send the request of an event; other events, and those without content, have none to send."""
        event = deserialize_message(data, self._event)
        if event.info.event_type != self._wanted or not event.request:
            return
        if not self._client.service_is_ready():
            self._node.get_logger().error(f"Service request hasn't been sent. The '{self._name}' service isn't ready !")
            return
        self._awaited = [each for each in self._awaited if not each.done()]
        self._awaited.append(self._client.call_async(event.request[0]))

    def wait_for_all_acked(self, timeout: Duration) -> bool:
        """Wait until all requests have been answered; return False if that does not happen in time."""
        end = time.monotonic() + timeout.nanoseconds / 1e9
        while not (done := all(each.done() for each in self._awaited)) and time.monotonic() < end:
            self._wait(_STEP)
        return done
