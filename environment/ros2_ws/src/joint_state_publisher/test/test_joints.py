"""The mathematics of the two publishers, without ROS."""

import math

import pytest
from joint_state_publisher.joints import Joints, Options
from robot_state_publisher.tree import Tree
from urdf_reader import Mimic, read

from environment.tests.robots import ARM, joint, robot

LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'


def test_tree_tells_moving_from_fixed():
    tree = Tree(read(ARM))
    assert [(t.parent, t.child, t.translation) for t in tree.fixed()] == [('base', 'camera', (0.1, 0, 0.2))]
    moving = tree.moving({'lift': 0.5, 'shoulder': 0.0, 'of another robot': 1.0})
    assert [(t.parent, t.child) for t in moving] == [('slider', 'finger'), ('upper', 'slider'), ('base', 'upper')]
    finger = moving[0]  # mimics: -2 * 0 + 0.25
    assert finger.rotation == pytest.approx((0, 0, math.sin(0.125), math.cos(0.125)))


def test_tree_a_given_position_of_a_mimic_stands():
    finger = Tree(read(ARM)).moving({'shoulder': 1.0, 'grip': 0.5})[0]
    assert finger.rotation == pytest.approx((0, 0, math.sin(0.25), math.cos(0.25)))


def test_tree_planar_is_fixed_and_floating_is_left_out():
    assert len(Tree(read(robot(joint('planar')))).fixed()) == 1
    tree = Tree(read(robot(joint('floating'))))
    assert tree.fixed() == [] == tree.moving({'j': 1.0})


def test_quaternions_have_a_positive_w():
    spinning = Tree(read(robot(joint('continuous', '<axis xyz="0 0 1"/>'))))
    assert spinning.moving({'j': 3.0})[0].rotation == pytest.approx((0, 0, math.sin(1.5), math.cos(1.5)))
    assert spinning.moving({'j': 4.0})[0].rotation == pytest.approx((0, 0, -math.sin(2.0), -math.cos(2.0)))


def test_joints_begin_at_zero_or_in_the_middle_of_their_limits():
    joints = Joints(read(ARM), Options())
    assert joints.names == ['shoulder', 'lift', 'grip']
    # Limits 0.5 to 1.5, the lower one 0.7 by the safety controller: the middle is 1.1; grip is -2 * 1.1 + 0.25.
    assert joints.state() == (pytest.approx([1.1, 0, -1.95]), [], [])
    assert Joints(read(ARM), Options(smallest_limits=False)).state()[0] == pytest.approx([1.0, 0, -1.75])


def test_joints_options():
    joints = Joints(
        read(ARM),
        Options(
            positions=False,
            velocities=True,
            efforts=True,
            mimic_tags=False,
            dependent={'lift': Mimic('grip', 3.0, 1.0)},
        ),
    )
    joints.free['grip'].velocity = 2.0
    assert joints.state() == ([], [0, 6, 2], [0, 0, 0])
    assert Joints(read(ARM), Options(zeros={'shoulder': 0.9})).state()[0] == pytest.approx([0.9, 0, -1.55])


def test_joints_follow_in_a_chain_but_not_in_a_circle():
    arm = read(ARM)
    chain = Joints(arm, Options(dependent={'lift': Mimic('grip', 10.0, 1.0)}, zeros={'shoulder': 1.0}))
    assert chain.state()[0] == pytest.approx([1.0, 10 * (-2 + 0.25) + 1, -1.75])
    with pytest.raises(ValueError, match='in a circle: lift, lift'):
        Joints(arm, Options(dependent={'lift': Mimic('lift')}))
    with pytest.raises(ValueError, match="'lift' mimics 'camera_joint', which does not move"):
        Joints(arm, Options(dependent={'lift': Mimic('camera_joint')}))


def test_joints_turn_round_at_their_limits():
    joints = Joints(read(robot(joint('revolute', LIMIT))), Options())
    seen = []
    for _ in range(6):
        joints.move(0.6)
        seen += joints.state()[0]
    assert seen == pytest.approx([0.6, 1.0, 0.4, -0.2, -0.8, -1.0])
    around = Joints(read(robot(joint('continuous'))), Options(zeros={'j': 3.0}))
    around.move(0.2)
    assert around.state()[0] == pytest.approx([-math.pi])
