"""A transform as a message."""

from builtin_interfaces.msg import Time
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
from tf_transformations import quaternion_from_euler


def transform(
    stamp: Time,
    parent: str,
    child: str,
    place: tuple[float, float, float],
    turn: tuple[float, float, float] = (0, 0, 0),
) -> TransformStamped:
    """Return where the frame `child` stands in `parent`: its place in metres, its roll, pitch and yaw in radians."""
    message = TransformStamped(child_frame_id=child)
    message.header.stamp, message.header.frame_id = stamp, parent
    message.transform.translation = Vector3(**dict(zip('xyz', map(float, place), strict=True)))
    message.transform.rotation = Quaternion(**dict(zip('xyzw', map(float, quaternion_from_euler(*turn)), strict=True)))
    return message
