"""
Read `sensor_msgs/PointCloud2` into numpy arrays, and make clouds from them.

A cloud is a block of bytes; its fields say which number lies where in each point. That is what numpy calls a
structured array.
"""

import array
import sys
from collections import namedtuple
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured
from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import Header

_DATATYPES = {
    PointField.INT8: np.dtype(np.int8),
    PointField.UINT8: np.dtype(np.uint8),
    PointField.INT16: np.dtype(np.int16),
    PointField.UINT16: np.dtype(np.uint16),
    PointField.INT32: np.dtype(np.int32),
    PointField.UINT32: np.dtype(np.uint32),
    PointField.FLOAT32: np.dtype(np.float32),
    PointField.FLOAT64: np.dtype(np.float64),
}

DUMMY_FIELD_PREFIX = 'unnamed_field'
_BIG_ENDIAN = sys.byteorder != 'little'


def dtype_from_fields(fields: Iterable[PointField], point_step: int | None = None) -> np.dtype:
    """
    Return the structured type of one point.

    A field with a count of n becomes the n members `name_0`, `name_1`, …; one without a name `unnamed_field_<i>`.

    :param point_step: bytes from one point to the next; by default what the fields take.
    :raises AssertionError: if a field has count 0 or two have the same name.
    """
    names, formats, offsets = [], [], []
    for index, field in enumerate(fields):
        assert field.count > 0, "Can't process fields with count = 0."
        element = _DATATYPES[field.datatype]
        base = field.name or f'{DUMMY_FIELD_PREFIX}_{index}'
        for part in range(field.count):
            name = base if field.count == 1 else f'{base}_{part}'
            assert name not in names, 'Duplicate field names are not allowed!'
            names.append(name)
            formats.append(element)
            offsets.append(field.offset + part * element.itemsize)
    layout = {'names': names, 'formats': formats, 'offsets': offsets}
    if point_step is not None:
        layout['itemsize'] = point_step
    return np.dtype(layout)


def read_points(
    cloud: PointCloud2,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable | None = None,
    reshape_organized_cloud: bool = False,
) -> np.ndarray:
    """
    Return the points of a cloud as a structured array.

    :param field_names: which fields; by default all.
    :param skip_nans: leave out points with a NaN, unless the cloud says that it has none (`is_dense`).
    :param uvs: indices of the points to return; by default all.
    :param reshape_organized_cloud: return an organized cloud as a 2-D array, indexed [column, row].
    """
    assert isinstance(cloud, PointCloud2), 'Cloud is not a sensor_msgs.msg.PointCloud2'
    points = np.ndarray(
        shape=(cloud.width * cloud.height,),
        dtype=dtype_from_fields(cloud.fields, point_step=cloud.point_step),
        buffer=cloud.data,
    )
    if field_names is not None:
        assert all(name in points.dtype.names for name in field_names), (
            'Requests field is not in the fields of the PointCloud!'
        )
        points = points[list(field_names)]
    if bool(cloud.is_bigendian) != _BIG_ENDIAN:
        points = points.byteswap()
    if skip_nans and not cloud.is_dense:
        valid = np.ones(len(points), dtype=bool)
        for name in points.dtype.names:
            valid &= ~np.isnan(points[name])
        points = points[valid]
    if uvs is not None:
        points = points[uvs if isinstance(uvs, np.ndarray) else np.fromiter(uvs, int)]
    if reshape_organized_cloud and cloud.height > 1:
        points = points.reshape(cloud.width, cloud.height)
    return points


def read_points_numpy(
    cloud: PointCloud2,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable | None = None,
    reshape_organized_cloud: bool = False,
) -> np.ndarray:
    """
    Return the points as a plain array with one row per point; the fields must have the same type.

    Parameters as in :func:`read_points`.
    """
    datatypes = {field.datatype for field in cloud.fields if field_names is None or field.name in field_names}
    assert len(datatypes) <= 1, 'All fields need to have the same datatype. Use `read_points()` otherwise.'
    return structured_to_unstructured(read_points(cloud, field_names, skip_nans, uvs, reshape_organized_cloud))


def read_points_list(
    cloud: PointCloud2, field_names: list[str] | None = None, skip_nans: bool = False, uvs: Iterable | None = None
) -> list[NamedTuple]:
    """Return the points as a list of named tuples. Easy to read, but slow. Parameters as in :func:`read_points`."""
    assert isinstance(cloud, PointCloud2), 'cloud is not a sensor_msgs.msg.PointCloud2'
    if field_names is None:
        field_names = [field.name for field in cloud.fields]
    point_type = namedtuple('Point', field_names)
    return [point_type._make(point) for point in read_points(cloud, field_names, skip_nans, uvs)]


def create_cloud(
    header: Header, fields: Iterable[PointField], points: Iterable, point_step: int | None = None
) -> PointCloud2:
    """
    Return a cloud.

    :param points: rows of values in the order of the fields, or a numpy array: structured as
        :func:`dtype_from_fields` says, or plain if all fields have the same type. A further dimension makes the cloud
        organized, indexed [column, row].
    :param point_step: bytes from one point to the next; by default what the points take.
    :raises AssertionError: if fields and points do not fit.
    """
    fields = list(fields)
    if not isinstance(points, np.ndarray):
        points = np.array([tuple(point) for point in points], dtype=dtype_from_fields(fields, point_step))
    elif points.dtype.names is None:
        assert all(fields[0].datatype == field.datatype for field in fields[1:]), (
            'All fields need to have the same datatype. Pass a structured NumPy array with multiple dtypes otherwise.'
        )
        points = unstructured_to_structured(points, dtype=dtype_from_fields(fields, point_step))
    else:
        assert points.dtype == dtype_from_fields(fields, point_step), (
            'PointFields and structured NumPy array dtype do not match for all fields! '
            'Check their field order, names and types.'
        )
    assert points.ndim <= 2, (
        'Too many dimensions for organized cloud! Points can only be organized in max. two dimensional space'
    )
    width = points.shape[0]
    height = points.shape[1] if points.ndim == 2 else 1
    cloud = PointCloud2(
        header=header,
        height=height,
        width=width,
        is_dense=False,
        is_bigendian=_BIG_ENDIAN,
        fields=fields,
        point_step=points.dtype.itemsize,
        row_step=points.dtype.itemsize * width,
    )
    # An array of bytes, because the setter copies anything else element by element.
    cloud.data = array.array('B', points.tobytes())
    return cloud


def create_cloud_xyz32(header: Header, points: Iterable) -> PointCloud2:
    """Return a cloud with the float32 fields x, y, z. Parameters as in :func:`create_cloud`."""
    fields = [
        PointField(name=name, offset=4 * index, datatype=PointField.FLOAT32, count=1)
        for index, name in enumerate('xyz')
    ]
    return create_cloud(header, fields, points)
