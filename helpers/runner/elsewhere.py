"""A test's own node in another ROS domain than the learner's program: it subscribes, publishes and relays there."""

import secrets
import threading
import time

from rclpy.context import Context
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node


class Elsewhere:
    """A node in `domain_id`; use it in a `with` block. Its name is hidden, as that of a test's node must be."""

    def __init__(self, domain_id: int):
        self.context = Context()
        self.context.init(domain_id=domain_id)
        self.node = Node(
            f'_{secrets.token_hex(6)}',
            context=self.context,
            start_parameter_services=False,
            enable_rosout=False,
            use_global_arguments=False,
        )
        self._executor = SingleThreadedExecutor(context=self.context)
        self._executor.add_node(self.node)
        self._thread: threading.Thread | None = None
        self._matched: dict[str, int] = {}  # publishers that there have ever been, by topic

    def listen(self, topic: str, msg_type, heard: list | None = None) -> list:
        """The list in which messages of `topic` appear while this node spins; `heard`, if it is given."""
        heard = [] if heard is None else heard

        def matched(info) -> None:
            self._matched[topic] = info.total_count

        events = SubscriptionEventCallbacks(matched=matched)
        self.node.create_subscription(msg_type, topic, heard.append, 100, event_callbacks=events)
        return heard

    def met(self, topic: str) -> int:
        """How many publishers a `listen` on `topic` has ever been connected with, those that are gone included."""
        return self._matched.get(topic, 0)

    def relay(self, topic: str, msg_type, to: 'Elsewhere') -> None:
        """Carry what is said on `topic` here to the domain of `to`, in the background, until the end of the block."""
        publisher = to.node.create_publisher(msg_type, topic, 100)
        self.node.create_subscription(msg_type, topic, publisher.publish, 100)
        self._thread = threading.Thread(target=self._executor.spin, daemon=True)
        self._thread.start()

    def nodes(self) -> list[str]:
        """The names of the nodes in this domain, tests' nodes left out."""
        return sorted(name for name in self.node.get_node_names() if not name.startswith('_'))

    def full_names(self) -> list[str]:
        """The nodes in this domain with their namespaces, tests' nodes left out."""
        found = self.node.get_node_names_and_namespaces()
        return sorted(f'{space.rstrip("/")}/{name}' for name, space in found if not name.startswith('_'))

    def wait_until(self, condition, timeout: float = 10.0) -> bool:
        """Spin until `condition()` is true; False after `timeout` seconds of wall time."""
        deadline = time.monotonic() + timeout
        while not condition():
            if time.monotonic() > deadline:
                return False
            self._executor.spin_once(timeout_sec=0.02)
        return True

    def __enter__(self) -> 'Elsewhere':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self._executor.shutdown(timeout_sec=1)
        if self._thread is not None:
            self._thread.join(5)
        self.node.destroy_node()
        self.context.try_shutdown()
