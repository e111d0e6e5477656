"""Programs that publish a text each second on /chatter, and that hear it."""

import argparse

import rclpy
from node_program.running import ros, run
from rclpy.node import Node
from rclpy.qos import QoSProfile, QoSReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import String

TOPIC = 'chatter'


class Talker(Node):
    """Counts aloud."""

    FIRST, LOG = 0, 'Publishing: "{}"'

    def __init__(self, name: str = 'talker', qos: QoSProfile | int = 10) -> None:
        """Publish with a quality of service."""
        super().__init__(name)
        self._count = self.FIRST
        self._publisher = self.create_publisher(String, TOPIC, qos)
        self._timer = self.create_timer(1.0, self._talk)

    def _talk(self) -> None:
        message = String(data=f'Hello World: {self._count}')
        self._count += 1
        self.get_logger().info(self.LOG.format(message.data))
        self._publisher.publish(message)


class Listener(Node):
    """Logs each message."""

    def __init__(self, name: str = 'listener', qos: QoSProfile | int = 10) -> None:
        """Subscribe with a quality of service."""
        super().__init__(name)
        self._subscription = self.create_subscription(String, TOPIC, self._hear, qos)

    def _hear(self, message: String) -> None:
        self.get_logger().info(f'I heard: [{message.data}]')


class SerializedListener(Node):
    """Logs the bytes of each message, as they came over the network."""

    def __init__(self) -> None:
        """Subscribe without deserialization."""
        super().__init__('serialized_subscriber')
        self._subscription = self.create_subscription(String, TOPIC, self._hear, 10, raw=True)

    def _hear(self, data: bytes) -> None:
        self.get_logger().info(f'I heard: "{data!r}"')


def talker(args: list[str] | None = None) -> None:
    """Run the talker."""
    run(Talker, args)


def listener(args: list[str] | None = None) -> None:
    """Run the listener."""
    run(Listener, args)


def listener_serialized(args: list[str] | None = None) -> None:
    """Run the listener to bytes."""
    run(SerializedListener, args)


def talker_qos(args: list[str] | None = None) -> None:
    """Run a talker that is best effort or, with --reliable, reliable."""
    _run_with_qos(Talker, 'talker', 'how many messages to publish', args)


def listener_qos(args: list[str] | None = None) -> None:
    """Run a listener that is best effort or, with --reliable, reliable."""
    _run_with_qos(Listener, 'listener', 'how many messages to hear', args)


def _run_with_qos(kind: type[Talker] | type[Listener], what: str, count_help: str, args: list[str] | None) -> None:
    parser = argparse.ArgumentParser(formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument('--reliable', action='store_true', help='reliable instead of best effort')
    parser.add_argument('-n', '--number_of_cycles', type=int, default=20, help=count_help)
    with ros(args) as (words, _):
        chosen = parser.parse_args(words)
        qos = qos_profile_sensor_data
        if chosen.reliable:
            qos = QoSProfile(depth=10, reliability=QoSReliabilityPolicy.RELIABLE)
        node = kind(f'{what}_qos', qos)
        node.get_logger().info(f'{"Reliable" if chosen.reliable else "Best effort"} {what}')
        for _ in range(chosen.number_of_cycles):
            rclpy.spin_once(node)
