"""A trackball: turn things by dragging a point over a sphere."""

import numpy

from tf_transformations.quaternion import (
    quaternion_from_matrix,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
)
from tf_transformations.vector import EPS, unit_vector, vector_norm


class Arcball:
    """
    The rotation that dragging has made.

    :param initial: a quaternion or a 4x4 rotation matrix to begin with.
    :raises ValueError: if it is neither.
    """

    def __init__(self, initial=None):
        self._axis = None  # the one that this drag turns about, if constrained
        self._axes = None  # those to choose from
        self._radius = 1.0
        self._center = [0.0, 0.0]
        self._vdown = numpy.array([0.0, 0.0, 1.0])
        self._constrain = False
        if initial is None:
            rotation = numpy.array([0.0, 0.0, 0.0, 1.0])
        else:
            initial = numpy.array(initial, dtype=numpy.float64)
            if initial.shape == (4, 4):
                rotation = quaternion_from_matrix(initial)
            elif initial.shape == (4,):
                rotation = unit_vector(initial)
            else:
                raise ValueError('initial not a quaternion or matrix.')
        self._qdown = self._qpre = self._qnow = rotation

    def place(self, center, radius):
        """Say where the ball is in the window, and how large."""
        self._radius = float(radius)
        self._center = [center[0], center[1]]

    def setaxes(self, *axes):
        """Say about which axes to turn when constrained."""
        self._axes = [unit_vector(axis) for axis in axes]

    def setconstrain(self, constrain):
        """Turn about the nearest of the axes only, if True."""
        self._constrain = constrain is True

    def getconstrain(self):
        """Return whether it is constrained to its axes."""
        return self._constrain

    def down(self, point):
        """Begin to drag at this point of the window."""
        self._vdown = arcball_map_to_sphere(point, self._center, self._radius)
        self._qdown = self._qpre = self._qnow
        self._axis = None
        if self._constrain and self._axes:
            self._axis = arcball_nearest_axis(self._vdown, self._axes)
            self._vdown = arcball_constrain_to_axis(self._vdown, self._axis)

    def drag(self, point):
        """Go on to this point of the window."""
        now = arcball_map_to_sphere(point, self._center, self._radius)
        if self._axis is not None:
            now = arcball_constrain_to_axis(now, self._axis)
        self._qpre = self._qnow
        normal = numpy.cross(self._vdown, now)
        if numpy.dot(normal, normal) < EPS:
            self._qnow = self._qdown
        else:
            turn = [*normal, numpy.dot(self._vdown, now)]
            self._qnow = quaternion_multiply(turn, self._qdown)

    def next(self, acceleration=0.0):
        """Go on turning as in the last drag."""
        ahead = quaternion_slerp(self._qpre, self._qnow, 2.0 + acceleration, False)
        self._qpre, self._qnow = self._qnow, ahead

    def matrix(self):
        """Return the homogeneous rotation matrix."""
        return quaternion_matrix(self._qnow)


def arcball_map_to_sphere(point, center, radius):
    """Return the point of the unit sphere that is seen at a point of the window."""
    x = (point[0] - center[0]) / radius
    y = (center[1] - point[1]) / radius
    length2 = x * x + y * y
    if length2 > 1.0:  # beside the ball: its rim
        return numpy.array([x, y, 0.0]) / numpy.sqrt(length2)
    return numpy.array([x, y, numpy.sqrt(1.0 - length2)])


def arcball_constrain_to_axis(point, axis):
    """Return the unit vector, on the visible side, that is nearest to the point and perpendicular to the axis."""
    axis = numpy.asarray(axis, dtype=numpy.float64)
    flat = numpy.asarray(point, dtype=numpy.float64)
    flat = flat - axis * numpy.dot(axis, flat)
    length = vector_norm(flat)
    if length > EPS:
        return (-flat if flat[2] < 0.0 else flat) / length
    if axis[2] == 1.0:
        return numpy.array([1.0, 0.0, 0.0])
    return unit_vector([-axis[1], axis[0], 0.0])


def arcball_nearest_axis(point, axes):
    """Return the axis whose great circle is nearest to the point."""
    return max(axes, key=lambda axis: numpy.dot(arcball_constrain_to_axis(point, axis), point), default=None)
