"""tf2_geometry_msgs: messages in another frame."""

import math
from copy import deepcopy

import numpy as np
import pytest
import tf2_geometry_msgs
import tf2_ros
from geometry_msgs.msg import (
    Point,
    Point32,
    PointStamped,
    Polygon,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    Quaternion,
    Vector3,
    Vector3Stamped,
)
from rclpy.time import Time
from std_msgs.msg import Header
from tf2_geometry_msgs.tf2_geometry_msgs import _build_affine, _decompose_affine, _get_mat_from_quat, _get_quat_from_mat

from environment.tests.tf2_messages import transform

HALF = math.sqrt(0.5)
QUARTER = (0, 0, HALF, HALF)  # a quarter turn to the left
POSE = Pose(position=Point(x=1.0, y=2.0, z=3.0), orientation=Quaternion(x=HALF, w=HALF))


@pytest.fixture
def to_map():
    """From `base` to `map`: a quarter turn about z, then 10 m along x."""
    return transform('map', 'base', 5.0, (10, 0, 0), QUARTER)


def xyz(message):
    return message.x, message.y, message.z


def expect_pose(pose):
    assert xyz(pose.position) == pytest.approx((8, 1, 3))
    orientation = pose.orientation
    assert (*xyz(orientation), orientation.w) == pytest.approx((0.5, 0.5, 0.5, 0.5))


def test_point(to_map):
    moved = tf2_geometry_msgs.do_transform_point(PointStamped(point=Point(x=1.0, y=2.0, z=3.0)), to_map)
    assert xyz(moved.point) == pytest.approx((8, 1, 3))
    assert moved.header == to_map.header
    assert type(moved.point.x) is float


def test_vector_is_turned_but_not_moved_and_the_transform_stays(to_map):
    before = deepcopy(to_map)
    moved = tf2_geometry_msgs.do_transform_vector3(Vector3Stamped(vector=Vector3(x=1.0, y=2.0, z=3.0)), to_map)
    assert xyz(moved.vector) == pytest.approx((-2, 1, 3))
    moved.header.frame_id = 'elsewhere'
    assert to_map == before


def test_poses(to_map):
    expect_pose(tf2_geometry_msgs.do_transform_pose(POSE, to_map))
    moved = tf2_geometry_msgs.do_transform_pose_stamped(PoseStamped(pose=POSE), to_map)
    expect_pose(moved.pose)
    assert moved.header.frame_id == 'map'


def test_covariance(to_map):
    covariance = np.diag([1.0, 4.0, 9.0, 0.1, 0.2, 0.3])
    covariance[0, 3] = covariance[3, 0] = 0.5
    message = PoseWithCovarianceStamped()
    message.pose.pose, message.pose.covariance = POSE, covariance.reshape(36)
    moved = tf2_geometry_msgs.do_transform_pose_with_covariance_stamped(message, to_map)
    expect_pose(moved.pose.pose)
    expected = np.diag([4.0, 1.0, 9.0, 0.2, 0.1, 0.3])
    expected[1, 4] = expected[4, 1] = 0.5
    assert np.array(moved.pose.covariance).reshape(6, 6) == pytest.approx(expected)
    assert tf2_geometry_msgs.transform_covariance(list(range(36)), transform('a', 'b')) == pytest.approx(range(36))


def test_polygon(to_map):
    polygon = PolygonStamped(polygon=Polygon(points=[Point32(x=1.0), Point32(y=1.0)]))
    moved = tf2_geometry_msgs.do_transform_polygon_stamped(polygon, to_map)
    assert [xyz(point) for point in moved.polygon.points] == [pytest.approx((10, 1, 0)), pytest.approx((9, 0, 0))]


@pytest.mark.parametrize(
    'message', [PointStamped(), Vector3Stamped(), PoseStamped(), PoseWithCovarianceStamped(), PolygonStamped()]
)
def test_buffers_know_the_types(message, to_map):
    buffer = tf2_ros.Buffer()
    buffer.set_transform(to_map, 'test')
    message.header = Header(frame_id='base', stamp=Time(seconds=5).to_msg())
    moved = buffer.transform(message, 'map')
    assert type(moved) is type(message) and moved.header.frame_id == 'map'


@pytest.mark.parametrize('quaternion', [(1, 0, 0, 0), (0, 1, 0, 0), (0.5, -0.5, 0.5, 0.5), (0.1, 0.2, 0.3, 0.9)])
def test_matrices_and_quaternions(quaternion):
    unit = np.array(quaternion) / np.linalg.norm(quaternion)
    back = _get_quat_from_mat(_get_mat_from_quat(2 * unit))
    assert back == pytest.approx(unit, abs=1e-9) or back == pytest.approx(-unit, abs=1e-9)
    assert back[0] >= 0.0
    rotation, translation = _decompose_affine(_build_affine(unit, (1, 2, 3)))
    assert rotation == pytest.approx(back) and translation == pytest.approx((1, 2, 3))
    assert _get_mat_from_quat(np.zeros(4)) == pytest.approx(np.eye(3))
