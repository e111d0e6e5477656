"""tf_transformations: conventions, and that inverse functions are inverse to each other."""

import math
import random

import numpy as np
import pytest
import tf_transformations as tft

HALF = math.sqrt(0.5)
AXES = [
    frame + axes
    for frame in 'sr'
    for axes in ('xyz', 'xyx', 'xzy', 'xzx', 'yzx', 'yzy', 'yxz', 'yxy', 'zxy', 'zxz', 'zyx', 'zyz')
]


@pytest.fixture(autouse=True)
def seeds():
    np.random.seed(1)
    random.seed(1)


def vector(size=3):
    return np.random.random(size) - 0.5


def test_every_name_of_upstream():
    assert set(tft.__all__) == {
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
    }
    for name in tft.__all__:
        assert callable(getattr(tft, name)) and getattr(tft, name).__doc__, name


def test_quaternions_are_x_y_z_w():
    assert tft.quaternion_from_euler(0, 0, math.pi / 2) == pytest.approx((0, 0, HALF, HALF))
    assert tft.quaternion_from_euler(math.pi, 0, 0) == pytest.approx((1, 0, 0, 0))
    assert tft.quaternion_about_axis(0.123, (1, 0, 0)) == pytest.approx((0.06146124, 0, 0, 0.99810947))
    assert tft.quaternion_multiply([1, -2, 3, 4], [-5, 6, 7, 8]) == pytest.approx((-44, -14, 48, 28))
    assert tft.quaternion_from_euler(1, 2, 3, 'ryxz') == pytest.approx((0.310622, -0.718287, 0.444435, 0.435953), 1e-5)


def test_roll_pitch_yaw():
    assert tft.euler_from_quaternion(tft.quaternion_from_euler(0.1, 0.2, 0.3)) == pytest.approx((0.1, 0.2, 0.3))
    # Roll first, then pitch, then yaw, about axes that stand still.
    expected = tft.concatenate_matrices(
        tft.rotation_matrix(0.3, (0, 0, 1)), tft.rotation_matrix(0.2, (0, 1, 0)), tft.rotation_matrix(0.1, (1, 0, 0))
    )
    assert tft.euler_matrix(0.1, 0.2, 0.3) == pytest.approx(expected)
    assert np.sum(tft.euler_matrix(1, 2, 3, 'syxz')[0]) == pytest.approx(-1.34786452)
    assert np.sum(tft.euler_matrix(1, 2, 3, (0, 1, 0, 1))[0]) == pytest.approx(-0.383436184)


@pytest.mark.parametrize('axes', AXES)
def test_all_sequences_of_axes(axes):
    matrix = tft.euler_matrix(*vector(), axes)
    assert tft.euler_matrix(*tft.euler_from_matrix(matrix, axes), axes) == pytest.approx(matrix)


def test_matrices_of_quaternions():
    for _ in range(20):
        quaternion = tft.random_quaternion()
        matrix = tft.quaternion_matrix(quaternion)
        back = np.array(tft.quaternion_from_matrix(matrix))
        assert back == pytest.approx(quaternion if np.dot(back, quaternion) > 0 else -quaternion)
        other = tft.random_quaternion()
        assert tft.quaternion_matrix(tft.quaternion_multiply(quaternion, other)) == pytest.approx(
            matrix @ tft.quaternion_matrix(other)
        )
        assert tft.quaternion_multiply(quaternion, tft.quaternion_inverse(quaternion)) == pytest.approx((0, 0, 0, 1))
    assert tft.quaternion_conjugate((1, 2, 3, 4)) == pytest.approx((-1, -2, -3, 4))
    assert tft.is_same_transform(np.eye(4), 2 * np.eye(4))
    assert not tft.is_same_transform(np.eye(4), tft.random_rotation_matrix())


def test_slerp():
    start, end = (0, 0, 0, 1), (0, 0, 1, 0)
    assert tft.quaternion_slerp(start, end, 0.5) == pytest.approx((0, 0, HALF, HALF))
    assert tft.quaternion_slerp(start, end, 0.0) == pytest.approx(start)
    assert tft.quaternion_slerp(start, end, 1.0, spin=1) == pytest.approx(end)
    quarter = (0, 0, HALF, HALF)
    opposite = tuple(-part for part in quarter)
    assert abs(
        np.dot(tft.quaternion_slerp(start, opposite, 0.5), tft.quaternion_slerp(start, quarter, 0.5))
    ) == pytest.approx(1)
    long_way = tft.quaternion_slerp(start, opposite, 0.5, shortestpath=False)
    assert abs(np.dot(long_way, tft.quaternion_slerp(start, quarter, 0.5))) < 0.5
    assert tft.quaternion_slerp(start, start, 0.3) == pytest.approx(start)


def test_elementary_matrices_and_back():
    assert tft.identity_matrix() == pytest.approx(np.eye(4))
    assert tft.translation_from_matrix(tft.translation_matrix((1, 2, 3))) == pytest.approx((1, 2, 3))
    point, direction = vector(), vector()
    for matrix, again in (
        (
            tft.rotation_matrix(0.7, direction, point),
            tft.rotation_matrix(*tft.rotation_from_matrix(tft.rotation_matrix(0.7, direction, point))),
        ),
        (
            tft.reflection_matrix(point, direction),
            tft.reflection_matrix(*tft.reflection_from_matrix(tft.reflection_matrix(point, direction))),
        ),
        (tft.scale_matrix(1.7, point), tft.scale_matrix(*tft.scale_from_matrix(tft.scale_matrix(1.7, point)))),
        (
            tft.scale_matrix(-3, point, direction),
            tft.scale_matrix(*tft.scale_from_matrix(tft.scale_matrix(-3, point, direction))),
        ),
    ):
        assert tft.is_same_transform(matrix, again)
    normal = np.cross(direction, vector())
    shear = tft.shear_matrix(0.5, direction, point, normal)
    assert np.linalg.det(shear) == pytest.approx(1)
    assert tft.is_same_transform(shear, tft.shear_matrix(*tft.shear_from_matrix(shear)))
    mirrored = tft.reflection_matrix((0, 0, 1), (0, 0, 1)) @ (1, 2, 3, 1)
    assert mirrored == pytest.approx((1, 2, -1, 1))


def test_compose_and_decompose():
    matrix = tft.compose_matrix((1, 2, 3), (0.1, 0.2, 0.3), (0.4, 0.5, 0.6), (7, 8, 9))
    scale, shear, angles, translation, perspective = tft.decompose_matrix(matrix)
    assert (scale, shear, angles) == (
        pytest.approx((1, 2, 3)),
        pytest.approx((0.1, 0.2, 0.3)),
        pytest.approx((0.4, 0.5, 0.6)),
    )
    assert translation == pytest.approx((7, 8, 9)) and perspective is None
    assert tft.compose_matrix() == pytest.approx(np.eye(4))
    assert tft.inverse_matrix(matrix) @ matrix == pytest.approx(np.eye(4))


@pytest.mark.parametrize('kind', ['orthogonal', 'parallel', 'perspective', 'pseudo'])
def test_projections(kind):
    point, normal, direction, eye = vector(), vector(), vector(), vector()
    options = {
        'orthogonal': {},
        'parallel': {'direction': direction},
        'perspective': {'perspective': eye},
        'pseudo': {'perspective': eye, 'pseudo': True},
    }[kind]
    matrix = tft.projection_matrix(point, normal, **options)
    again = tft.projection_matrix(*tft.projection_from_matrix(matrix, pseudo=kind == 'pseudo'))
    assert tft.is_same_transform(matrix, again)
    if kind == 'pseudo':
        plain = tft.projection_matrix(point, normal, perspective=eye)
        assert tft.is_same_transform(plain, tft.projection_matrix(point, normal) @ matrix)
    else:
        projected = matrix @ (0.3, 0.2, 0.9, 1.0)
        projected = projected[:3] / projected[3]
        assert np.dot(projected - point, normal) == pytest.approx(0, abs=1e-9)


def test_projection_of_a_known_point():
    matrix = tft.projection_matrix((3, 0, 0), (1, 1, 0), (1, 0, 0))
    moved = matrix @ (0.2, 0.7, 0.1, 1.0)
    assert (moved[0], moved[1]) == pytest.approx((3.0 - 0.7, 0.7))
    with pytest.raises(ValueError, match='eigenvalue'):
        tft.projection_from_matrix(np.eye(4))


@pytest.mark.parametrize('perspective', [False, True])
def test_clipping(perspective):
    left, right, bottom, top, near, far = 1.0, 2.0, -1.0, 3.0, 2.0, 5.0
    matrix = tft.clip_matrix(left, right, bottom, top, near, far, perspective)
    corner = matrix @ (left, bottom, near, 1.0)
    assert corner / corner[3] == pytest.approx((-1, -1, -1, 1))
    other = matrix @ (right, top, near if perspective else far, 1.0)
    assert other / other[3] == pytest.approx((1, 1, -1 if perspective else 1, 1))
    with pytest.raises(ValueError, match='invalid frustrum'):
        tft.clip_matrix(right, left, bottom, top, near, far, perspective)


@pytest.mark.parametrize('usesvd', [True, False])
def test_superimposition(usesvd):
    points = (np.random.rand(4, 50) - 0.5) * 20.0
    points[3] = 1.0
    matrix = tft.concatenate_matrices(
        tft.translation_matrix(vector()), tft.random_rotation_matrix(), tft.scale_matrix(1.7)
    )
    moved = matrix @ points
    assert tft.superimposition_matrix(points, moved, scaling=True, usesvd=usesvd) == pytest.approx(matrix)
    mirrored = points[:3] * [[1], [1], [-1]]
    assert np.linalg.det(tft.superimposition_matrix(points, mirrored, usesvd=usesvd)[:3, :3]) == pytest.approx(1)
    with pytest.raises(ValueError, match='wrong shape'):
        tft.superimposition_matrix(points[:, :2], moved[:, :2])


def test_crystal():
    assert tft.orthogonalization_matrix((10, 10, 10), (90, 90, 90))[:3, :3] == pytest.approx(10 * np.eye(3))
    assert np.sum(tft.orthogonalization_matrix([9.8, 12.0, 15.5], [87.2, 80.7, 69.7])) == pytest.approx(43.063229)


def test_vectors():
    block = np.random.rand(6, 5, 3)
    assert tft.vector_norm([3, 4]) == 5.0 and tft.vector_norm([]) == 0.0
    assert tft.vector_norm(block, axis=-1) == pytest.approx(np.linalg.norm(block, axis=-1))
    assert tft.unit_vector(block, axis=1) == pytest.approx(block / np.linalg.norm(block, axis=1, keepdims=True))
    lengths, units = np.empty((6, 3)), np.empty_like(block)
    assert tft.vector_norm(block, axis=1, out=lengths) is None and tft.unit_vector(block, axis=1, out=units) is None
    assert units == pytest.approx(block / lengths[:, np.newaxis, :])
    assert list(tft.unit_vector([])) == [] and list(tft.unit_vector([2.0])) == [1.0]
    assert tft.random_vector(4).shape == (4,)


def test_arcball():
    ball = tft.Arcball(initial=np.eye(4))
    ball.place([320, 320], 320)
    ball.down([500, 250])
    ball.drag([475, 275])
    assert np.sum(ball.matrix()) == pytest.approx(3.90583455)
    ball = tft.Arcball(initial=[0, 0, 0, 1])
    ball.place([320, 320], 320)
    ball.setaxes([1, 1, 0], [-1, 1, 0])
    ball.setconstrain(True)
    assert ball.getconstrain()
    ball.down([400, 200])
    ball.drag([200, 400])
    assert np.sum(ball.matrix()) == pytest.approx(0.2055924)
    before = ball.matrix()
    ball.next()
    assert not tft.is_same_transform(before, ball.matrix())
    with pytest.raises(ValueError, match='not a quaternion or matrix'):
        tft.Arcball(initial=[1, 2])
