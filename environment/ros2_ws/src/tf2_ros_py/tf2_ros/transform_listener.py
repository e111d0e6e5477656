"""Receive transforms."""

from threading import Thread, current_thread

from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from rclpy.task import Future
from tf2_msgs.msg import TFMessage

from tf2_ros.buffer import Buffer

DEFAULT_TF_TOPIC, DEFAULT_STATIC_TF_TOPIC = '/tf', '/tf_static'


class TransformListener:
    """
    Fill a buffer with what is published on `/tf` and `/tf_static`.

    It listens until :meth:`unregister`, or until the node is destroyed. Its subscriptions are in a group of their own,
    so that with a `MultiThreadedExecutor` transforms arrive while another callback of the node waits for them.

    :param buffer: the buffer to fill.
    :param node: the node that subscribes.
    :param spin_thread: spin the whole node in a thread of its own; do not spin it elsewhere then.
    :param qos: QoS or depth for `/tf`; by default the last 100, volatile.
    :param static_qos: QoS or depth for `/tf_static`; by default the last 100, transient local.
    :param tf_topic: another topic than `/tf`.
    :param tf_static_topic: another topic than `/tf_static`.
    :param static_only: listen to the static transforms alone.
    """

    def __init__(
        self,
        buffer: Buffer,
        node: Node,
        *,
        spin_thread: bool = False,
        qos: QoSProfile | int | None = None,
        static_qos: QoSProfile | int | None = None,
        tf_topic: str = DEFAULT_TF_TOPIC,
        tf_static_topic: str = DEFAULT_STATIC_TF_TOPIC,
        static_only: bool = False,
    ) -> None:
        if qos is None:
            qos = QoSProfile(depth=100, durability=DurabilityPolicy.VOLATILE, history=HistoryPolicy.KEEP_LAST)
        if static_qos is None:
            static_qos = QoSProfile(
                depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST
            )
        self.buffer = buffer
        self.node = node
        self.group = ReentrantCallbackGroup()
        if not static_only:
            self.tf_sub = node.create_subscription(TFMessage, tf_topic, self.callback, qos, callback_group=self.group)
        self.tf_static_sub = node.create_subscription(
            TFMessage, tf_static_topic, self.static_callback, static_qos, callback_group=self.group
        )
        if spin_thread:
            self.executor = SingleThreadedExecutor(context=node.context)
            self._stop = Future()
            self.dedicated_listener_thread = Thread(target=_spin, args=(self.executor, node, self._stop))
            self.dedicated_listener_thread.start()

    def __del__(self) -> None:
        if hasattr(self, 'dedicated_listener_thread'):
            # First let it finish what it does: a shutdown pulls the ground from under a running callback.
            if not self._stop.done():
                self._stop.set_result(None)
            if self.dedicated_listener_thread is not current_thread():
                self.dedicated_listener_thread.join()
            self.executor.shutdown()
        self.unregister()

    def unregister(self) -> None:
        """Stop listening: destroy the subscriptions."""
        for subscription in ('tf_sub', 'tf_static_sub'):
            if hasattr(self, subscription):
                self.node.destroy_subscription(getattr(self, subscription))

    def callback(self, data: TFMessage) -> None:
        """Take what came on `/tf` into the buffer."""
        for transform in data.transforms:
            self.buffer.set_transform(transform, 'default_authority')

    def static_callback(self, data: TFMessage) -> None:
        """Take what came on `/tf_static` into the buffer."""
        for transform in data.transforms:
            self.buffer.set_transform_static(transform, 'default_authority')


def _spin(executor: SingleThreadedExecutor, node: Node, stop: Future) -> None:
    executor.add_node(node)
    try:
        executor.spin_until_future_complete(stop)
    except ExternalShutdownException:
        pass
    executor.remove_node(node)
