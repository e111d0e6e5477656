"""Poses as homogeneous 4 x 4 matrices: from ROS messages and from numbers."""

import numpy as np


def matrix(translation=(0.0, 0.0, 0.0), quaternion=(0.0, 0.0, 0.0, 1.0)) -> np.ndarray:
    """Return the pose of a translation (x, y, z in m) and a quaternion (x, y, z, w), which need not be normalised."""
    x, y, z, w = quaternion
    norm = x * x + y * y + z * z + w * w
    s = 2.0 / norm if norm > 0.0 else 0.0
    tx, ty, tz = translation
    return np.array(
        (
            (1.0 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), tx),
            (s * (x * y + z * w), 1.0 - s * (x * x + z * z), s * (y * z - x * w), ty),
            (s * (x * z - y * w), s * (y * z + x * w), 1.0 - s * (x * x + y * y), tz),
            (0.0, 0.0, 0.0, 1.0),
        )
    )


def from_transform(transform) -> np.ndarray:
    """Return a ``geometry_msgs/Transform``, or the transform of a ``TransformStamped``, as a matrix."""
    transform = getattr(transform, 'transform', transform)
    t, q = transform.translation, transform.rotation
    return matrix((t.x, t.y, t.z), (q.x, q.y, q.z, q.w))


def from_pose(pose) -> np.ndarray:
    """Return a ``geometry_msgs/Pose`` as a matrix."""
    p, q = pose.position, pose.orientation
    return matrix((p.x, p.y, p.z), (q.x, q.y, q.z, q.w))
