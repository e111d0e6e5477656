"""sensor_msgs_py.point_cloud2 and tf2_sensor_msgs."""

import math
from copy import deepcopy

import numpy as np
import pytest
import tf2_ros
from sensor_msgs.msg import PointCloud2, PointField
from sensor_msgs_py import point_cloud2
from std_msgs.msg import Header
from tf2_sensor_msgs import do_transform_cloud, transform_points

from environment.tests.tf2_messages import transform

POINTS = np.array([[1, 2, 0], [10, 20, 30], [4, math.nan, 6]], dtype=np.float32)
HEADER = Header(frame_id='laser')


def field(name, offset, datatype=PointField.FLOAT32, count=1):
    return PointField(name=name, offset=offset, datatype=datatype, count=count)


MIXED = [
    field('x', 0),
    field('y', 4),
    field('z', 8),
    field('ring', 12, PointField.UINT16),
    field('time', 14, PointField.FLOAT64),
]
MIXED_POINTS = [(1.0, 2.0, 3.0, 7, 0.25), (4.0, 5.0, 6.0, 8, 0.5)]


@pytest.fixture
def cloud():
    return point_cloud2.create_cloud_xyz32(HEADER, POINTS)


def test_create(cloud):
    assert (cloud.width, cloud.height, cloud.point_step, cloud.row_step) == (3, 1, 12, 36)
    assert bytes(cloud.data) == POINTS.tobytes()
    assert cloud == point_cloud2.create_cloud_xyz32(HEADER, POINTS.tolist())
    assert [(f.name, f.offset, f.datatype) for f in cloud.fields] == [('x', 0, 7), ('y', 4, 7), ('z', 8, 7)]


def test_read(cloud):
    np.testing.assert_equal(point_cloud2.read_points_numpy(cloud), POINTS)
    assert point_cloud2.read_points(cloud)['y'][1] == 20
    np.testing.assert_equal(point_cloud2.read_points_numpy(cloud, ['z', 'x']), POINTS[:, [2, 0]])
    np.testing.assert_equal(point_cloud2.read_points_numpy(cloud, skip_nans=True), POINTS[:2])
    np.testing.assert_equal(point_cloud2.read_points_numpy(cloud, uvs=iter([1, 0])), POINTS[[1, 0]])
    assert point_cloud2.read_points_list(cloud)[1].z == 30
    with pytest.raises(AssertionError, match='Requests field is not in the fields of the PointCloud!'):
        point_cloud2.read_points(cloud, ['intensity'])
    with pytest.raises(AssertionError):
        point_cloud2.read_points('cloud')


def test_fields_of_different_types():
    cloud = point_cloud2.create_cloud(HEADER, MIXED, MIXED_POINTS)
    assert [tuple(point) for point in point_cloud2.read_points(cloud)] == MIXED_POINTS
    assert cloud.point_step == 22
    with pytest.raises(AssertionError, match='same datatype'):
        point_cloud2.read_points_numpy(cloud)
    assert point_cloud2.read_points_numpy(cloud, ['x', 'y']).shape == (2, 2)
    structured = np.array(MIXED_POINTS, point_cloud2.dtype_from_fields(MIXED))
    assert cloud == point_cloud2.create_cloud(HEADER, MIXED, structured)
    with pytest.raises(AssertionError, match='do not match'):
        point_cloud2.create_cloud(HEADER, MIXED[:3], structured)


def test_fields_with_a_count_and_without_a_name():
    fields = [field('v', 0, count=2), field('', 8)]
    assert point_cloud2.dtype_from_fields(fields).names == ('v_0', 'v_1', 'unnamed_field_1')
    with pytest.raises(AssertionError, match='Duplicate field names'):
        point_cloud2.dtype_from_fields([field('x', 0), field('x', 4)])
    with pytest.raises(AssertionError, match='count = 0'):
        point_cloud2.dtype_from_fields([field('x', 0, count=0)])


def test_padding_and_byte_order(cloud):
    padded = point_cloud2.create_cloud(HEADER, cloud.fields, POINTS, point_step=20)
    assert (padded.point_step, len(padded.data)) == (20, 60)
    np.testing.assert_equal(point_cloud2.read_points_numpy(padded), POINTS)
    swapped = PointCloud2(
        header=HEADER,
        height=1,
        width=3,
        fields=cloud.fields,
        point_step=12,
        row_step=36,
        is_bigendian=not cloud.is_bigendian,
        data=POINTS.byteswap().tobytes(),
    )
    before = deepcopy(swapped)
    np.testing.assert_equal(point_cloud2.read_points_numpy(swapped), POINTS)
    assert swapped == before


def test_organized(cloud):
    grid = np.arange(18, dtype=np.float32).reshape(3, 2, 3)
    organized = point_cloud2.create_cloud_xyz32(HEADER, grid)
    assert (organized.width, organized.height) == (3, 2)
    assert point_cloud2.read_points(organized).shape == (6,)
    np.testing.assert_equal(point_cloud2.read_points_numpy(organized, reshape_organized_cloud=True), grid)
    moved = do_transform_cloud(organized, transform('map', 'laser', xyz=(1, 0, 0)))
    assert (moved.width, moved.height) == (3, 2)
    with pytest.raises(AssertionError, match='Too many dimensions'):
        point_cloud2.create_cloud_xyz32(HEADER, np.zeros((2, 2, 2, 3), np.float32))


def test_transform(cloud):
    before = deepcopy(cloud)
    moved = do_transform_cloud(cloud, transform('map', 'laser', xyz=(0, 0, 100), xyzw=(1, 0, 0, 0)))
    np.testing.assert_allclose(point_cloud2.read_points_numpy(moved)[:2], [[1, -2, 100], [10, -20, 70]])
    assert moved.header.frame_id == 'map' and cloud == before
    half = math.sqrt(0.5)
    assert transform_points(
        [[1, 2, 3]], transform('a', 'b', xyz=(10, 0, 0), xyzw=(0, 0, half, half)).transform
    ) == pytest.approx(np.array([[8, 1, 3]]))


def test_transform_keeps_other_fields_and_the_frame_without_a_stamp():
    cloud = point_cloud2.create_cloud(HEADER, MIXED, MIXED_POINTS, point_step=32)
    moved = do_transform_cloud(cloud, transform('map', 'laser', xyz=(300, 300, 300)).transform)
    assert [tuple(point) for point in point_cloud2.read_points(moved)] == [
        (301.0, 302.0, 303.0, 7, 0.25),
        (304.0, 305.0, 306.0, 8, 0.5),
    ]
    assert moved.header.frame_id == 'laser' and moved.point_step == 32
    with pytest.raises(AssertionError, match='needs the fields x, y, and z'):
        do_transform_cloud(point_cloud2.create_cloud(HEADER, MIXED[:2], [(1.0, 2.0)]), transform('a', 'b'))


def test_buffers_know_clouds(cloud):
    buffer = tf2_ros.Buffer()
    buffer.set_transform_static(transform('laser', 'base', xyz=(0, 0, 100)), 'test')
    moved = buffer.transform(cloud, 'base')
    np.testing.assert_allclose(point_cloud2.read_points_numpy(moved)[:2], POINTS[:2] - [0, 0, 100])
    assert moved.header.frame_id == 'base'


def test_an_array_with_padding_needs_its_step(cloud):
    points = np.zeros(3, dtype=point_cloud2.dtype_from_fields(cloud.fields, point_step=32))
    with pytest.raises(AssertionError, match='dtype do not match'):
        point_cloud2.create_cloud(HEADER, cloud.fields, points)
    assert point_cloud2.create_cloud(HEADER, cloud.fields, points, point_step=32).point_step == 32
