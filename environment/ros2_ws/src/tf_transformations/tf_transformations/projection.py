"""Projections onto planes, and the view of a camera."""

import numpy

from tf_transformations.vector import EPS, unit_vector


def projection_matrix(point, normal, direction=None, perspective=None, pseudo=False):
    """
    Return the matrix that projects onto the plane through a point with a normal.

    :param direction: project along this direction; by default along the normal.
    :param perspective: project from this point.
    :param pseudo: let a perspective projection keep the relative depth: orthogonal after pseudo is perspective.
    """
    normal = unit_vector(normal[:3])
    offset = float(numpy.dot(point[:3], normal))  # of the plane from the origin
    matrix = numpy.identity(4)
    if perspective is not None:
        eye = numpy.asarray(perspective[:3], dtype=numpy.float64)
        height = float(numpy.dot(eye, normal))
        towards = eye + normal if pseudo else eye
        matrix[:3, :3] = (height - offset) * numpy.identity(3) - numpy.outer(towards, normal)
        matrix[:3, 3] = offset * towards
        matrix[3, :3] = -normal
        matrix[3, 3] = height
        return matrix
    along = normal if direction is None else numpy.asarray(direction[:3], dtype=numpy.float64)
    along = along / numpy.dot(along, normal)
    matrix[:3, :3] -= numpy.outer(along, normal)
    matrix[:3, 3] = offset * along
    return matrix


def projection_from_matrix(matrix, pseudo=False):
    """
    Return `point, normal, direction, perspective, pseudo`, with which :func:`projection_matrix` makes the matrix.

    The point is homogeneous, `x, y, z, 1`; direction and perspective are None where they do not apply.

    :param pseudo: whether a perspective matrix was made to keep the depth; the matrix does not tell.
    :raises ValueError: if it is no projection.
    """
    matrix = numpy.array(matrix, dtype=numpy.float64)
    linear = matrix[:3, :3]
    if numpy.linalg.norm(matrix[3, :3]) > 1e-8:
        matrix = matrix / numpy.linalg.norm(matrix[3, :3])
        linear = matrix[:3, :3]
        normal = -matrix[3, :3]
        height = matrix[3, 3]
        offset = (2.0 * height - numpy.trace(linear) - (1.0 if pseudo else 0.0)) / 3.0
        eye = (height - offset) * normal - linear @ normal
        if pseudo:
            eye = eye - normal
        return numpy.append(offset * normal, 1.0), normal, None, eye, pseudo
    # What an affine projection takes away is of rank one: direction times normal.
    taken = numpy.identity(3) - linear
    left, sizes, right = numpy.linalg.svd(taken)
    if sizes[0] < 1e-8 or sizes[1] > 1e-8:
        raise ValueError('no eigenvector corresponding to eigenvalue 0')
    direction, normal = left[:, 0], right[0]
    point = numpy.append(numpy.linalg.pinv(taken) @ matrix[:3, 3], 1.0)
    if abs(abs(numpy.dot(direction, normal)) - 1.0) < 1e-8:
        return point, normal, None, None, False
    return point, normal, direction, None, False


def clip_matrix(left, right, bottom, top, near, far, perspective=False):
    """
    Return the matrix to normalized device coordinates, -1 to 1 inside the frustum with these bounds.

    :param perspective: the frustum is a pyramid whose top is the origin, looking along z; otherwise a box.
    :raises ValueError: if the bounds are in the wrong order, or near is not before the eye.
    """
    if left >= right or bottom >= top or near >= far:
        raise ValueError('invalid frustrum')
    low = numpy.array((left, bottom, near), dtype=numpy.float64)
    high = numpy.array((right, top, far), dtype=numpy.float64)
    size = high - low
    matrix = numpy.zeros((4, 4))
    if not perspective:
        matrix[:3, :3] = numpy.diag(2.0 / size)
        matrix[:3, 3] = -(high + low) / size
        matrix[3, 3] = 1.0
        return matrix
    if near <= EPS:
        raise ValueError('invalid frustrum: near <= 0')
    matrix[0, 0], matrix[1, 1] = -2.0 * near / size[:2]
    matrix[:2, 2] = (high + low)[:2] / size[:2]
    matrix[2, 2] = -(far + near) / size[2]
    matrix[2, 3] = 2.0 * near * far / size[2]
    matrix[3, 2] = -1.0
    return matrix
