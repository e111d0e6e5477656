"""Words and comparisons for the tests about frames."""

import math

import numpy as np
from tf_transformations import quaternion_matrix

from helpers.runner import expect

ORDER = 'In which order does a Quaternion have x, y, z and w?'


def words(vector, digits: int = 2) -> str:
    """A point or direction as text, with so many digits after the point: (0.89, 0, 0.86)."""
    return '(' + ', '.join(f'{round(float(value), digits) + 0.0:.9g}' for value in vector[:3]) + ')'


def apart(one, other) -> tuple[str, str]:
    """Two points or directions as texts, with more digits if they would look alike."""
    for digits in (2, 3, 4):
        if words(one, digits) != words(other, digits):
            return words(one, digits), words(other, digits)
    return words(one, 6), words(other, 6)


def same(one, other, tolerance: float = 1e-4) -> bool:
    """Whether two arrays of numbers are equal, but for rounding."""
    return np.shape(one) == np.shape(other) and np.allclose(one, other, rtol=0, atol=tolerance)


def explain(right, told: str, *reasons: tuple[object, str], rule: str = '') -> None:
    """Fail with `told` unless `right` is true. Of the reasons (condition, text), the first that holds is added."""
    expect(right, ' '.join([told, *[text for holds, text in reasons if holds][:1]]), rule)


def check_rotation(transform, hint: str = '') -> None:
    """Fail, with the hint, unless the quaternion of a TransformStamped has the length 1."""
    turn = transform.transform.rotation
    length = math.hypot(turn.x, turn.y, turn.z, turn.w)
    expect(
        same(length, 1.0),
        f'The quaternion of `{transform.child_frame_id}` has the length {length:.2f}, expected '
        f'1: it is no rotation. {hint}',
    )


def w_first(transform, expected) -> bool:
    """Whether a TransformStamped has the turn of this matrix, but its quaternion begins with w."""
    turn = transform.transform.rotation
    return same(quaternion_matrix((turn.y, turn.z, turn.w, turn.x))[:3, :3], np.asarray(expected)[:3, :3])


def origin(matrix) -> np.ndarray:
    """Where the frame of a 4x4 matrix is: x, y, z."""
    return np.asarray(matrix)[:3, 3]


def axis(matrix, name: str) -> np.ndarray:
    """Where an axis of the frame of a 4x4 matrix points to: a unit vector."""
    return np.asarray(matrix)[:3, 'xyz'.index(name)]
