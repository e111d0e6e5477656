"""
Quaternions, Euler angles and homogeneous matrices, under the names of ROS's `tf.transformations`.

Quaternions are `x, y, z, w`; angles are radians; matrices are 4x4 numpy arrays that act on columns. Euler angles
follow an axis sequence such as `sxyz`: `s` for axes that stand still, `r` for axes that turn along. The default,
`sxyz`, is ROS's roll, pitch, yaw. The mathematics is that of the library `transforms3d`, which itself puts w first.
"""

import math

import numpy
import transforms3d

from tf_transformations.arcball import Arcball, arcball_constrain_to_axis, arcball_map_to_sphere, arcball_nearest_axis
from tf_transformations.projection import clip_matrix, projection_from_matrix, projection_matrix
from tf_transformations.quaternion import (
    _reorder_output_quaternion,
    quaternion_conjugate,
    quaternion_from_matrix,
    quaternion_inverse,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
    random_quaternion,
)
from tf_transformations.vector import random_vector, unit_vector, vector_norm

__all__ = [
    'Arcball',
    'arcball_constrain_to_axis',
    'arcball_map_to_sphere',
    'arcball_nearest_axis',
    'clip_matrix',
    'compose_matrix',
    'concatenate_matrices',
    'decompose_matrix',
    'euler_from_matrix',
    'euler_from_quaternion',
    'euler_matrix',
    'identity_matrix',
    'inverse_matrix',
    'is_same_transform',
    'orthogonalization_matrix',
    'projection_from_matrix',
    'projection_matrix',
    'quaternion_about_axis',
    'quaternion_conjugate',
    'quaternion_from_euler',
    'quaternion_from_matrix',
    'quaternion_inverse',
    'quaternion_matrix',
    'quaternion_multiply',
    'quaternion_slerp',
    'random_quaternion',
    'random_rotation_matrix',
    'random_vector',
    'reflection_from_matrix',
    'reflection_matrix',
    'rotation_from_matrix',
    'rotation_matrix',
    'scale_from_matrix',
    'scale_matrix',
    'shear_from_matrix',
    'shear_matrix',
    'superimposition_matrix',
    'translation_from_matrix',
    'translation_matrix',
    'unit_vector',
    'vector_norm',
]

TRANSLATION_IDENTITY = [0.0, 0.0, 0.0]
ROTATION_IDENTITY = numpy.identity(3, dtype=numpy.float64)
ZOOM_IDENTITY = [1.0, 1.0, 1.0]
SHEAR_IDENTITY = TRANSLATION_IDENTITY


def _affine(translation=TRANSLATION_IDENTITY, rotation=ROTATION_IDENTITY):
    return transforms3d.affines.compose(translation, rotation, ZOOM_IDENTITY)


# -- rotations


def quaternion_from_euler(ai, aj, ak, axes='sxyz'):
    """Return the quaternion of three Euler angles: with the default axes roll, pitch and yaw."""
    return _reorder_output_quaternion(transforms3d.euler.euler2quat(ai, aj, ak, axes=axes))


def euler_from_quaternion(quaternion, axes='sxyz'):
    """Return the Euler angles of a quaternion: with the default axes roll, pitch and yaw."""
    return euler_from_matrix(quaternion_matrix(quaternion), axes)


def euler_matrix(ai, aj, ak, axes='sxyz'):
    """Return the matrix of a rotation by Euler angles."""
    return _affine(rotation=transforms3d.euler.euler2mat(ai, aj, ak, axes=axes))


def euler_from_matrix(matrix, axes='sxyz'):
    """Return the Euler angles of a rotation matrix. Several triplets can mean the same rotation; this is one."""
    return transforms3d.euler.mat2euler(matrix, axes=axes)


def quaternion_about_axis(angle, axis):
    """Return the quaternion of a rotation by an angle about an axis of any length."""
    return _reorder_output_quaternion(transforms3d.quaternions.axangle2quat(axis, angle))


def random_rotation_matrix(rand=None):
    """Return a uniformly distributed rotation; `rand` as in :func:`random_quaternion`."""
    return quaternion_matrix(random_quaternion(rand))


def rotation_matrix(angle, direction, point=None):
    """Return the matrix of a rotation by an angle about an axis through a point, by default the origin."""
    return transforms3d.axangles.axangle2aff(direction, angle, point=point)


def rotation_from_matrix(matrix):
    """Return `angle, direction, point` of a rotation matrix."""
    direction, angle, point = transforms3d.axangles.aff2axangle(matrix)
    return angle, direction, point


# -- other elementary transformations


def identity_matrix():
    """Return the transformation that changes nothing."""
    return _affine()


def translation_matrix(direction):
    """Return the matrix of a translation."""
    return _affine(direction)


def translation_from_matrix(matrix):
    """Return the translation x, y, z of a matrix."""
    return transforms3d.affines.decompose(matrix)[0]


def reflection_matrix(point, normal):
    """Return the matrix that mirrors at the plane through a point with a normal."""
    return transforms3d.reflections.rfnorm2aff(normal, point[:3])


def reflection_from_matrix(matrix):
    """Return `point, normal` of a mirror plane."""
    normal, point = transforms3d.reflections.aff2rfnorm(matrix)
    return point, normal


def scale_matrix(factor, origin=None, direction=None):
    """Return the matrix that scales about an origin, in all directions or along one; factor -1 mirrors at the point."""
    return transforms3d.zooms.zfdir2aff(factor, direction=direction, origin=origin)


def scale_from_matrix(matrix):
    """Return `factor, origin, direction` of a scaling; the direction is None if it is the same in all."""
    factor, direction, origin = transforms3d.zooms.aff2zfdir(matrix)
    return factor, origin, direction


def shear_matrix(angle, direction, point, normal):
    """
    Return the matrix that shears by an angle along a direction.

    The plane through the point with the normal stays; the direction must lie in it.
    """
    return transforms3d.shears.sadn2aff(angle, direction, normal, point)


def shear_from_matrix(matrix):
    """Return `angle, direction, point, normal` of a shear."""
    angle, direction, normal, point = transforms3d.shears.aff2sadn(matrix)
    return angle, direction, point, normal


# -- combinations


def decompose_matrix(matrix):
    """
    Return `scale, shear, angles, translate, perspective` of an affine matrix; see :func:`compose_matrix`.

    As upstream's, it does not look for a perspective, and returns None for it.
    """
    translation, rotation, zoom, shear = transforms3d.affines.decompose(matrix)
    return zoom, shear, euler_from_matrix(rotation), translation, None


def compose_matrix(scale=None, shear=None, angles=None, translate=None, perspective=None):
    """
    Return the matrix that scales, shears, rotates and translates, in this order.

    :param scale: factors along x, y, z.
    :param shear: factors for x-y, x-z, y-z.
    :param angles: Euler angles about the fixed axes x, y, z.
    :param translate: x, y, z.
    :param perspective: accepted for upstream's signature, which ignores it as well.
    """
    return transforms3d.affines.compose(
        TRANSLATION_IDENTITY if translate is None else translate,
        ROTATION_IDENTITY if angles is None else transforms3d.euler.euler2mat(*angles),
        ZOOM_IDENTITY if scale is None else scale,
        SHEAR_IDENTITY if shear is None else shear,
    )


def inverse_matrix(matrix):
    """Return the inverse of a square matrix."""
    return numpy.linalg.inv(matrix)


def concatenate_matrices(*matrices):
    """Return the product of the matrices; the last one acts first."""
    product = numpy.identity(4)
    for matrix in matrices:
        product = numpy.dot(product, matrix)
    return product


def is_same_transform(matrix0, matrix1):
    """Return whether two homogeneous matrices mean the same, which their common factor does not change."""
    first, second = (numpy.array(matrix, dtype=numpy.float64) for matrix in (matrix0, matrix1))
    return bool(numpy.allclose(first / first[3, 3], second / second[3, 3]))


def orthogonalization_matrix(lengths, angles):
    """
    Return the matrix from the coordinates of a crystal cell to Cartesian ones.

    :param lengths: of the cell's edges a, b, c.
    :param angles: between them, alpha, beta, gamma, in degrees.
    """
    a, b, c = lengths
    alpha, beta, gamma = numpy.radians(angles)
    # The cosine of the angle that alpha and beta span on the unit sphere.
    spherical = (math.cos(alpha) * math.cos(beta) - math.cos(gamma)) / (math.sin(alpha) * math.sin(beta))
    matrix = numpy.identity(4)
    matrix[:3, 0] = (
        a * math.sin(beta) * math.sqrt(1.0 - spherical**2),
        -a * math.sin(beta) * spherical,
        a * math.cos(beta),
    )
    matrix[:3, 1] = 0.0, b * math.sin(alpha), b * math.cos(alpha)
    matrix[:3, 2] = 0.0, 0.0, c
    return matrix


def superimposition_matrix(v0, v1, scaling=False, usesvd=True):
    """
    Return the matrix that brings the points `v0` nearest to the points `v1`, in the sense of least squares.

    :param v0: points as columns, of three rows or more; what is below the third row is ignored.
    :param scaling: allow to scale, alike in all directions.
    :param usesvd: use Kabsch's method by singular values; otherwise Horn's by quaternions.
    :raises ValueError: if the shapes differ or there are less than three points.
    """
    first = numpy.array(v0, dtype=numpy.float64)[:3]
    second = numpy.array(v1, dtype=numpy.float64)[:3]
    if first.shape != second.shape or first.shape[1] < 3:
        raise ValueError('Vector sets are of wrong shape or type.')
    centre0, centre1 = first.mean(axis=1), second.mean(axis=1)
    first -= centre0[:, numpy.newaxis]
    second -= centre1[:, numpy.newaxis]
    correlation = second @ first.T
    if usesvd:
        left, _, right = numpy.linalg.svd(correlation)
        # Without this factor the best match may be a mirror image.
        handed = numpy.diag([1.0, 1.0, numpy.sign(numpy.linalg.det(left @ right)) or 1.0])
        rotation = left @ handed @ right
    else:
        rotation = quaternion_matrix(_horn(correlation))[:3, :3]
    scale = math.sqrt((second**2).sum() / (first**2).sum()) if scaling else 1.0
    matrix = numpy.identity(4)
    matrix[:3, :3] = scale * rotation
    matrix[:3, 3] = centre1 - matrix[:3, :3] @ centre0
    return matrix


def _horn(correlation):
    """Return the quaternion of the rotation that maximizes the trace of its inverse times the correlation."""
    transposed = correlation.T
    trace = numpy.trace(correlation)
    symmetric = numpy.empty((4, 4))
    symmetric[:3, :3] = correlation + transposed - trace * numpy.identity(3)
    symmetric[3, 3] = trace
    symmetric[3, :3] = symmetric[:3, 3] = (
        correlation[2, 1] - correlation[1, 2],
        correlation[0, 2] - correlation[2, 0],
        correlation[1, 0] - correlation[0, 1],
    )
    return numpy.linalg.eigh(symmetric)[1][:, -1]
