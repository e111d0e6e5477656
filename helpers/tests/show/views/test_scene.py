"""The scene: nodes, poses relative to the one above, and what a renderer is told of changes."""

import numpy as np
import pytest

from helpers.show.views import poses
from helpers.show.views.scene import Scene, part
from helpers.show.views.shapes import Axes, Box, Line, Points

LIFT = poses.matrix((0.0, 0.0, 1.0))
TURN = poses.matrix(quaternion=(0.0, 0.0, 0.5**0.5, 0.5**0.5))  # 90 degrees about z


def test_poses_opacities_and_visibility_come_down_the_tree():
    scene = Scene()
    scene.pose('robot', TURN)
    scene.set('robot/arm/hand', Box())
    scene.pose('robot/arm', poses.matrix((1.0, 0.0, 0.0)))
    scene.pose('robot/arm/hand', LIFT)
    scene.appearance('robot', opacity=0.5)
    scene.appearance('robot/arm', opacity=0.5)
    [item] = scene.items()
    assert item.path == 'robot/arm/hand' and item.opacity == 0.25
    np.testing.assert_allclose(item.pose[:3, 3], (0.0, 1.0, 1.0), atol=1e-12)
    np.testing.assert_allclose(item.pose[:3, 0], (0.0, 1.0, 0.0), atol=1e-12)
    scene.appearance('robot/arm', visible=False)
    assert scene.items() == []


def test_a_renderer_is_told_only_what_has_changed():
    scene = Scene()
    scene.set('a', Axes(0.2))
    scene.pose('a', LIFT)
    assert len(scene.changes().shapes) == 1 and not scene.changes()
    scene.set('a', Axes(0.2))
    scene.pose('a', LIFT.copy())
    scene.appearance('a', visible=True, opacity=1.0)
    assert not scene.changes(), 'nothing has changed'
    scene.pose('a', TURN)
    changes = scene.changes()
    assert [node.path for node in changes.poses] == ['a'] and not changes.shapes
    cloud = Points([[0, 0, 0]])
    scene.set('a', cloud)
    assert scene.changes() and not scene.changes()
    assert [node.path for node in scene.everything().shapes] == ['a'] and not scene.changes()


def test_what_is_deleted_is_gone_with_all_below_it():
    scene = Scene()
    for path in ('a/b/c', 'a/bc', 'ab'):
        scene.set(path, Axes())
    scene.changes()
    scene.delete('a/b')
    assert scene.paths() == ['a', 'a/bc', 'ab'] and len(scene.changes().deleted) == 1
    scene.delete('nothing')
    scene.set('a/b', Axes())
    assert 'a/b' in scene and 'a/b/c' not in scene
    scene.clear()
    assert scene.paths() == [] and scene.items() == []


def test_a_part_of_a_scene_has_short_names():
    scene = Scene()
    robot = scene.below('robot')
    robot.set('wheel', Axes())
    robot.pose('wheel', LIFT)
    scene.set('other', Axes())
    assert scene.paths() == ['robot', 'robot/wheel', 'other'] and robot.paths() == ['wheel']
    assert [item.path for item in robot.items()] == ['wheel']
    robot.clear()
    assert scene.paths() == ['robot', 'other']


def test_names_with_slashes_are_one_part():
    scene = Scene()
    for name in ('robot1/base_link', 'robot1', 'robot1%2Fbase_link', ''):
        scene.set(part(name), Axes())
    assert len(scene.paths()) == len(set(scene.paths())) == 4


@pytest.mark.parametrize(
    'wrong',
    [
        lambda: Scene().set('a', 'b'),
        lambda: Scene().set('/a', Axes()),
        lambda: Scene().pose('a', np.eye(3)),
        lambda: Line([[0, 0]]),
        lambda: Line([[0, 0, 0]], pieces=True),
        lambda: Points(np.zeros((3, 3)), np.zeros((2, 3))),
    ],
)
def test_what_makes_no_sense_is_refused(wrong):
    with pytest.raises((TypeError, ValueError)):
        wrong()


def test_empty_arrays_are_fine():
    assert Line([]).points.shape == (0, 3) and Points([]).points.shape == (0, 3)
