"""A node that is told when its publisher and its subscription find and lose their counterparts."""

from typing import Any

from node_program.running import ros
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String

PUBLISHED = 'pub_topic_matched_event_detect'
HEARD = 'sub_topic_matched_event_detect'
PATIENCE = 10.0


class MatchedEventDetection(Node):
    """Logs how many counterparts its publisher and its subscription have."""

    def __init__(self) -> None:
        """Register a callback for each."""
        super().__init__('matched_event_detection_node')
        self._connected = {'subscription': False, 'publisher': False}
        self.event = Future()
        self.create_publisher(
            String,
            PUBLISHED,
            10,
            event_callbacks=PublisherEventCallbacks(matched=lambda info: self._tell('subscription', info)),
        )
        self.create_subscription(
            String,
            HEARD,
            lambda _: None,
            10,
            event_callbacks=SubscriptionEventCallbacks(matched=lambda info: self._tell('publisher', info)),
        )

    def _tell(self, counterpart: str, info: Any) -> None:
        said = None
        if not self._connected[counterpart]:
            said = f'First {counterpart} is connected.' if info.current_count else None
        elif info.current_count:
            said = (
                f'The changed number of connected {counterpart} is {info.current_count_change} and current number of '
                f'connected {counterpart} is {info.current_count}'
            )
        else:
            said = f'Last {counterpart} is disconnected.'
        self._connected[counterpart] = bool(info.current_count)
        if said:
            self.get_logger().info(said)
        self.event.set_result(True)


def main(args: list[str] | None = None) -> None:
    """Make two counterparts of each and destroy them again; wait for each event."""
    with ros(args):
        watcher, subscriber, publisher = MatchedEventDetection(), Node('multi_sub_node'), Node('multi_pub_node')
        executor = SingleThreadedExecutor()
        for node in (watcher, subscriber, publisher):
            executor.add_node(node)

        def wait() -> None:
            executor.spin_until_future_complete(watcher.event, PATIENCE)
            watcher.event = Future()

        for node, what, make, destroy in (
            (
                subscriber,
                'subscription',
                lambda: subscriber.create_subscription(String, PUBLISHED, lambda _: None, 10),
                subscriber.destroy_subscription,
            ),
            (
                publisher,
                'publisher',
                lambda: publisher.create_publisher(String, HEARD, 10),
                publisher.destroy_publisher,
            ),
        ):
            made = []
            for _ in range(2):
                node.get_logger().info(f'Create a new {what}.')
                made.append(make())
                wait()
            for each in made:
                node.get_logger().info(f'Destroy a {what}.')
                destroy(each)
                wait()
