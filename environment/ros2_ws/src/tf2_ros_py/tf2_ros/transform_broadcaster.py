"""Send transforms of frames that move."""

from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.qos import QoSProfile
from tf2_msgs.msg import TFMessage


class TransformBroadcaster:
    """
    Publish transforms on `/tf`.

    :param node: the node that publishes.
    :param qos: QoS or depth of the publisher; by default the last 100.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        self.pub_tf = node.create_publisher(TFMessage, '/tf', QoSProfile(depth=100) if qos is None else qos)

    def sendTransform(self, transform: TransformStamped | list[TransformStamped]) -> None:
        """Send one transform, or several in one message."""
        self.pub_tf.publish(TFMessage(transforms=as_list(transform)))


def as_list(transform: TransformStamped | list[TransformStamped]) -> list[TransformStamped]:
    """Return one transform, or any iterable of them, as a list."""
    return list(transform) if hasattr(transform, '__iter__') else [transform]
