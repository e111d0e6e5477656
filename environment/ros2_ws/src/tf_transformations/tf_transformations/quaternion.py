"""Quaternions `x, y, z, w`."""

import math

import numpy
import transforms3d

from tf_transformations.vector import EPS, unit_vector


def _reorder_input_quaternion(quaternion):
    """Return w, x, y, z, as transforms3d wants it."""
    x, y, z, w = quaternion
    return w, x, y, z


def _reorder_output_quaternion(quaternion):
    """Return x, y, z, w of what transforms3d gives."""
    w, x, y, z = quaternion
    return x, y, z, w


def quaternion_matrix(quaternion):
    """Return the homogeneous rotation matrix of a quaternion of any length."""
    matrix = numpy.identity(4)
    matrix[:3, :3] = transforms3d.quaternions.quat2mat(_reorder_input_quaternion(quaternion))
    return matrix


def quaternion_from_matrix(matrix):
    """Return the quaternion, with w not negative, of the rotation in a matrix."""
    rotation = transforms3d.affines.decompose(numpy.asarray(matrix))[1]
    return _reorder_output_quaternion(transforms3d.quaternions.mat2quat(rotation))


def quaternion_multiply(quaternion1, quaternion0):
    """Return the product: the rotation that applies `quaternion0` first."""
    return _reorder_output_quaternion(
        transforms3d.quaternions.qmult(_reorder_input_quaternion(quaternion1), _reorder_input_quaternion(quaternion0))
    )


def quaternion_conjugate(quaternion):
    """Return the quaternion with the other sign of x, y, z: of a unit quaternion, the inverse."""
    x, y, z, w = quaternion
    return numpy.array((-x, -y, -z, w), dtype=numpy.float64)


def quaternion_inverse(quaternion):
    """Return the quaternion whose product with this one is 1."""
    return quaternion_conjugate(quaternion) / numpy.dot(quaternion, quaternion)


def quaternion_slerp(quat0, quat1, fraction, spin=0, shortestpath=True):
    """
    Return the rotation at a fraction of the way from one to another, at constant angular velocity.

    :param spin: this many half turns more on the way.
    :param shortestpath: go the shorter of the two ways round.
    """
    start, end = unit_vector(quat0[:4]), unit_vector(quat1[:4])
    if fraction == 0.0:
        return start
    if fraction == 1.0:
        return end
    cosine = numpy.dot(start, end)
    if abs(abs(cosine) - 1.0) < EPS:
        return start
    if shortestpath and cosine < 0.0:
        cosine, end = -cosine, -end
    angle = math.acos(cosine) + spin * math.pi
    if abs(angle) < EPS:
        return start
    return (math.sin((1.0 - fraction) * angle) * start + math.sin(fraction * angle) * end) / math.sin(angle)


def random_quaternion(rand=None):
    """
    Return a uniformly distributed unit quaternion.

    :param rand: three independent numbers, uniformly distributed from 0 to 1; by default new ones.
    """
    if rand is None:
        rand = numpy.random.rand(3)
    assert len(rand) == 3
    # Shoemake's method: a point on the product of two circles, whose radii share the unit length.
    first, second = math.sqrt(1.0 - rand[0]), math.sqrt(rand[0])
    angle1, angle2 = 2.0 * math.pi * rand[1], 2.0 * math.pi * rand[2]
    return numpy.array(
        (math.sin(angle1) * first, math.cos(angle1) * first, math.sin(angle2) * second, math.cos(angle2) * second),
        dtype=numpy.float64,
    )
