"""Send transforms that never change."""

from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tf2_msgs.msg import TFMessage

from tf2_ros.transform_broadcaster import as_list


class StaticTransformBroadcaster:
    """
    Publish static transforms on `/tf_static`, where late listeners get them too.

    A listener that comes late gets the publisher's last message, so each message repeats all that was sent before.

    :param node: the node that publishes.
    :param qos: QoS or depth of the publisher; by default the last 1, transient local.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        if qos is None:
            qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST)
        self.pub_tf = node.create_publisher(TFMessage, '/tf_static', qos)
        self.net_message = TFMessage()

    def sendTransform(self, transform: TransformStamped | list[TransformStamped]) -> None:
        """Send one transform or several; one for a child frame that was sent before replaces that."""
        latest = {sent.child_frame_id: sent for sent in self.net_message.transforms}
        latest.update((new.child_frame_id, new) for new in as_list(transform))
        self.net_message.transforms = list(latest.values())
        self.pub_tf.publish(self.net_message)
