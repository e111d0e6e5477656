"""Functions that take a point cloud from a transform's source frame into its target frame."""

import numpy as np
import tf2_ros
from geometry_msgs.msg import Transform, TransformStamped
from numpy.lib.recfunctions import structured_to_unstructured
from sensor_msgs.msg import PointCloud2
from sensor_msgs_py.point_cloud2 import create_cloud, read_points
from std_msgs.msg import Header


def to_msg_msg(msg):
    """Return the message: it is one already."""
    return msg


def from_msg_msg(msg):
    """Return the message: that is what was asked for."""
    return msg


tf2_ros.ConvertRegistration().add_to_msg(PointCloud2, to_msg_msg)
tf2_ros.ConvertRegistration().add_from_msg(PointCloud2, from_msg_msg)


def transform_points(point_cloud: np.ndarray, transform: Transform) -> np.ndarray:
    """Return the points, an array of n rows x, y, z, turned and moved by a `Transform`."""
    translation = transform.translation
    matrix = _get_mat_from_quat(
        np.array([transform.rotation.w, transform.rotation.x, transform.rotation.y, transform.rotation.z])
    )
    return np.asarray(point_cloud) @ matrix.T + (translation.x, translation.y, translation.z)


def do_transform_cloud(cloud: PointCloud2, transform: Transform | TransformStamped) -> PointCloud2:
    """
    Return a new cloud whose fields x, y, z are in the target frame; the other fields stay as they are.

    With a plain `Transform` the cloud's frame id stays, because it tells no other.

    :raises AssertionError: if the cloud has no x, y and z.
    """
    header = Header(stamp=cloud.header.stamp, frame_id=cloud.header.frame_id)
    if isinstance(transform, TransformStamped):
        header.frame_id = transform.header.frame_id
        transform = transform.transform
    assert set('xyz') <= {field.name for field in cloud.fields}, (
        'Point cloud needs the fields x, y, and z for the transformation'
    )
    points = read_points(cloud).copy()  # it is a view of the message
    moved = transform_points(structured_to_unstructured(points[['x', 'y', 'z']]), transform)
    for index, name in enumerate('xyz'):
        points[name] = moved[:, index]
    result = create_cloud(header, cloud.fields, points, cloud.point_step)
    # An organized cloud stays organized, and a dense one dense.
    result.height, result.width, result.row_step = cloud.height, cloud.width, cloud.width * cloud.point_step
    result.is_dense = cloud.is_dense
    return result


tf2_ros.TransformRegistration().add(PointCloud2, do_transform_cloud)


def _get_mat_from_quat(quaternion: np.ndarray) -> np.ndarray:
    """Return the 3x3 matrix of a quaternion w, x, y, z of any length; the identity if the length is zero."""
    length2 = float(quaternion @ quaternion)
    if length2 < np.finfo(np.float64).eps:
        return np.eye(3)
    w, (x, y, z) = quaternion[0], quaternion[1:]
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + (2.0 / length2) * (w * cross + cross @ cross)
