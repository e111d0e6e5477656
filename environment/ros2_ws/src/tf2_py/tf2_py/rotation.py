"""
Rotations as plain floats: a quaternion is `x, y, z, w`, a matrix is nine floats, row by row.

Plain floats, because numpy is many times slower for so few numbers. Nothing here raises: a rotation without meaning
(a zero quaternion, infinities) becomes NaN, which the buffer refuses.
"""

from math import acos, inf, nan, sin, sqrt


def matrix_from_quaternion(x, y, z, w):
    """Return the rotation matrix of a quaternion of any length; all NaN if the length is zero."""
    length2 = x * x + y * y + z * z + w * w
    s = 2.0 / length2 if length2 else inf
    xs = x * s
    ys = y * s
    zs = z * s
    wx = w * xs
    wy = w * ys
    wz = w * zs
    xx = x * xs
    xy = x * ys
    xz = x * zs
    yy = y * ys
    yz = y * zs
    zz = z * zs
    return (1.0 - (yy + zz), xy - wz, xz + wy, xy + wz, 1.0 - (xx + zz), yz - wx, xz - wy, yz + wx, 1.0 - (xx + yy))


def quaternion_from_matrix(m00, m01, m02, m10, m11, m12, m20, m21, m22):
    """
    Return the quaternion of a rotation matrix.

    Of the two quaternions that mean the same rotation it gives the one with positive w if the trace is positive, else
    the one whose component of the largest diagonal element is positive.
    """
    trace = m00 + m11 + m22
    try:
        if trace > 0.0:
            s = sqrt(trace + 1.0)
            w = 0.5 * s
            s = 0.5 / s
            return (m21 - m12) * s, (m02 - m20) * s, (m10 - m01) * s, w
        if m00 < m11:
            largest = 2 if m11 < m22 else 1
        else:
            largest = 2 if m00 < m22 else 0
        if largest == 0:
            s = sqrt(m00 - m11 - m22 + 1.0)
            x = 0.5 * s
            s = 0.5 / s
            return x, (m10 + m01) * s, (m20 + m02) * s, (m21 - m12) * s
        if largest == 1:
            s = sqrt(m11 - m22 - m00 + 1.0)
            y = 0.5 * s
            s = 0.5 / s
            return (m01 + m10) * s, y, (m21 + m12) * s, (m02 - m20) * s
        s = sqrt(m22 - m00 - m11 + 1.0)
        z = 0.5 * s
        s = 0.5 / s
        return (m02 + m20) * s, (m12 + m21) * s, z, (m10 - m01) * s
    except (ValueError, ZeroDivisionError):  # not a rotation at all
        return nan, nan, nan, nan


def canonical(x, y, z, w):
    """
    Return the rotation as a unit quaternion with the sign that :func:`quaternion_from_matrix` chooses.

    That is what passing through a matrix does. The usual case is written out, for it is part of every insertion.
    """
    length2 = x * x + y * y + z * z + w * w
    s = 2.0 / length2 if length2 else inf
    xs = x * s
    ys = y * s
    zs = z * s
    xx = x * xs
    yy = y * ys
    zz = z * zs
    trace = 1.0 - (yy + zz) + (1.0 - (xx + zz)) + (1.0 - (xx + yy))
    if trace > 0.0:
        root = sqrt(trace + 1.0)
        scale = w / root  # half of the inverse root times the difference of two elements, which is 2 w x s
        return xs * scale, ys * scale, zs * scale, 0.5 * root
    return quaternion_from_matrix(*matrix_from_quaternion(x, y, z, w))


def multiply(ax, ay, az, aw, bx, by, bz, bw):
    """Return the product a b: the rotation that applies b first."""
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def rotate(qx, qy, qz, qw, x, y, z):
    """Return the vector turned by the unit quaternion."""
    # p = q v, a quaternion; the result is the vector part of p times the conjugate of q.
    px = qw * x + qy * z - qz * y
    py = qw * y + qz * x - qx * z
    pz = qw * z + qx * y - qy * x
    pw = -qx * x - qy * y - qz * z
    return (
        -pw * qx + px * qw - py * qz + pz * qy,
        -pw * qy + py * qw - pz * qx + px * qz,
        -pw * qz + pz * qw - px * qy + py * qx,
    )


def interpolate(a, b, ratio):
    """
    Return the sample between two samples `(parent, x, y, z, qx, qy, qz, qw)`; ratio 0 is a, ratio 1 is b.

    Straight in the translation, along the shorter great circle in the rotation.
    """
    parent, ax, ay, az, aqx, aqy, aqz, aqw = a
    _, bx, by, bz, bqx, bqy, bqz, bqw = b
    rest = 1.0 - ratio
    dot = aqx * bqx + aqy * bqy + aqz * bqz + aqw * bqw
    cosine = dot if dot >= 0.0 else -dot
    theta = acos(cosine) if cosine < 1.0 else 0.0
    if theta:
        d = 1.0 / sin(theta)
        s0 = sin(rest * theta) * d
        s1 = sin(ratio * theta) * d
        if dot < 0.0:
            s1 = -s1
        aqx = aqx * s0 + bqx * s1
        aqy = aqy * s0 + bqy * s1
        aqz = aqz * s0 + bqz * s1
        aqw = aqw * s0 + bqw * s1
    return (parent, rest * ax + ratio * bx, rest * ay + ratio * by, rest * az + ratio * bz, aqx, aqy, aqz, aqw)
