"""Short ways to make and read transforms."""

from geometry_msgs.msg import TransformStamped
from rclpy.time import Time


def transform(parent, child, seconds=0.0, xyz=(0.0, 0.0, 0.0), xyzw=(0.0, 0.0, 0.0, 1.0)):
    """Return a TransformStamped."""
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id = parent, child
    message.header.stamp = Time(nanoseconds=round(seconds * 1e9)).to_msg()
    translation, rotation = message.transform.translation, message.transform.rotation
    translation.x, translation.y, translation.z = map(float, xyz)
    rotation.x, rotation.y, rotation.z, rotation.w = map(float, xyzw)
    return message


def position(message):
    """Return x, y, z of a TransformStamped."""
    translation = message.transform.translation
    return translation.x, translation.y, translation.z
