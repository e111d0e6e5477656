"""
Functions that take a message from a transform's source frame into its target frame.

The arguments stay as they were, the result shares nothing with them, and its fields are plain floats.
"""

from collections.abc import Iterable
from copy import deepcopy

import numpy as np
import tf2_ros
from geometry_msgs.msg import (
    Point,
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    Quaternion,
    TransformStamped,
    Vector3,
    Vector3Stamped,
)


def to_msg_msg(msg):
    """Return the message: it is one already."""
    return msg


def from_msg_msg(msg):
    """Return the message: that is what was asked for."""
    return msg


for _type in (Vector3Stamped, PoseStamped, PointStamped):
    tf2_ros.ConvertRegistration().add_to_msg(_type, to_msg_msg)
    tf2_ros.ConvertRegistration().add_from_msg(_type, from_msg_msg)


def _get_mat_from_quat(quaternion: np.ndarray) -> np.ndarray:
    """Return the 3x3 matrix of a quaternion w, x, y, z of any length; the identity if the length is zero."""
    w, x, y, z = (float(component) for component in quaternion)
    length2 = w * w + x * x + y * y + z * z
    if length2 < np.finfo(np.float64).eps:
        return np.eye(3)
    s = 2.0 / length2
    return np.array(
        [
            [1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
            [s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)],
            [s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)],
        ]
    )


def _get_quat_from_mat(rot_mat: np.ndarray) -> np.ndarray:
    """
    Return the quaternion w, x, y, z, with w not negative, that is nearest to a 3x3 matrix.

    Bar-Itzhack's method ("New method for extracting the quaternion from a rotation matrix", 2000): it is the
    eigenvector of the largest eigenvalue of a symmetric 4x4 matrix. That also forgives a matrix that is not quite a
    rotation.
    """
    m = np.asarray(rot_mat, dtype=float)
    trace = np.trace(m)
    symmetric = np.empty((4, 4))
    symmetric[1:, 1:] = m + m.T - trace * np.eye(3)
    symmetric[0, 0] = trace
    symmetric[0, 1:] = symmetric[1:, 0] = (m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1])
    quaternion = np.linalg.eigh(symmetric)[1][:, -1]
    return -quaternion if quaternion[0] < 0.0 else quaternion


def _build_affine(rotation: Iterable | None = None, translation: Iterable | None = None) -> np.ndarray:
    """Return the 4x4 matrix of a rotation w, x, y, z and a translation x, y, z; what is missing is the identity."""
    affine = np.eye(4)
    if rotation is not None:
        affine[:3, :3] = _get_mat_from_quat(np.asarray(rotation))
    if translation is not None:
        affine[:3, 3] = np.asarray(translation)
    return affine


def _transform_to_affine(transform: TransformStamped) -> np.ndarray:
    """Return the 4x4 matrix of a transform."""
    rotation, translation = transform.transform.rotation, transform.transform.translation
    return _build_affine(
        (rotation.w, rotation.x, rotation.y, rotation.z), (translation.x, translation.y, translation.z)
    )


def _decompose_affine(affine: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the rotation w, x, y, z and the translation x, y, z of a 4x4 matrix."""
    return _get_quat_from_mat(affine[:3, :3]), affine[:3, 3]


def _moved(affine: np.ndarray, point) -> list[float]:
    return (affine[:3, :3] @ (point.x, point.y, point.z) + affine[:3, 3]).tolist()


def do_transform_point(point: PointStamped, transform: TransformStamped) -> PointStamped:
    """Return the point in the target frame."""
    x, y, z = _moved(_transform_to_affine(transform), point.point)
    return PointStamped(header=deepcopy(transform.header), point=Point(x=x, y=y, z=z))


def do_transform_vector3(vector3: Vector3Stamped, transform: TransformStamped) -> Vector3Stamped:
    """Return the vector in the target frame: turned, but not moved, for a vector is not at any place."""
    rotation = transform.transform.rotation
    affine = _build_affine((rotation.w, rotation.x, rotation.y, rotation.z))
    x, y, z = _moved(affine, vector3.vector)
    return Vector3Stamped(header=deepcopy(transform.header), vector=Vector3(x=x, y=y, z=z))


def do_transform_pose(pose: Pose, transform: TransformStamped) -> Pose:
    """Return the pose (one without a header) in the target frame."""
    position, orientation = pose.position, pose.orientation
    affine = _transform_to_affine(transform) @ _build_affine(
        (orientation.w, orientation.x, orientation.y, orientation.z), (position.x, position.y, position.z)
    )
    quaternion, point = _decompose_affine(affine)
    w, qx, qy, qz = quaternion.tolist()
    x, y, z = point.tolist()
    return Pose(position=Point(x=x, y=y, z=z), orientation=Quaternion(x=qx, y=qy, z=qz, w=w))


def do_transform_pose_stamped(pose: PoseStamped, transform: TransformStamped) -> PoseStamped:
    """Return the pose in the target frame."""
    return PoseStamped(header=deepcopy(transform.header), pose=do_transform_pose(pose.pose, transform))


def transform_covariance(cov_in: Iterable[float], transform: TransformStamped) -> np.ndarray:
    """
    Return a 6x6 covariance (36 numbers: x, y, z, and the rotations about x, y, z) as seen from the target frame.

    Each 3x3 block C becomes R C R', R being the transform's rotation.
    """
    rotation = _transform_to_affine(transform)[:3, :3]
    both = np.kron(np.eye(2), rotation)
    return (both @ np.asarray(list(cov_in), dtype=float).reshape(6, 6) @ both.T).reshape(36)


def do_transform_pose_with_covariance_stamped(
    pose: PoseWithCovarianceStamped, transform: TransformStamped
) -> PoseWithCovarianceStamped:
    """Return the pose and its covariance in the target frame."""
    result = PoseWithCovarianceStamped(header=deepcopy(transform.header))
    result.pose.pose = do_transform_pose(pose.pose.pose, transform)
    result.pose.covariance = transform_covariance(pose.pose.covariance, transform)
    return result


def do_transform_polygon_stamped(polygon: PolygonStamped, transform: TransformStamped) -> PolygonStamped:
    """Return the polygon in the target frame."""
    affine = _transform_to_affine(transform)
    result = PolygonStamped(header=deepcopy(transform.header))
    for point in polygon.polygon.points:
        x, y, z = _moved(affine, point)
        result.polygon.points.append(Point32(x=x, y=y, z=z))
    return result


for _type, _function in (
    (PointStamped, do_transform_point),
    (Vector3Stamped, do_transform_vector3),
    (PoseStamped, do_transform_pose_stamped),
    (PoseWithCovarianceStamped, do_transform_pose_with_covariance_stamped),
    (PolygonStamped, do_transform_polygon_stamped),
):
    tf2_ros.TransformRegistration().add(_type, _function)
