"""The reader of robot descriptions: what it understands, and what it says of bad ones."""

import math

import numpy
import pytest
from urdf_reader import Box, Cylinder, Mesh, Mimic, Sphere, UrdfError, read, resolve

from environment.tests.robots import ARM, joint, robot

LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'


def test_what_a_description_says():
    arm = read(ARM)
    assert (arm.name, arm.root, list(arm.links)) == ('arm', 'base', ['base', 'upper', 'slider', 'finger', 'camera'])
    base, camera = arm.links['base'], arm.links['camera']
    assert [v.geometry for v in base.visuals] == [Box((0.2, 0.3, 0.4)), Sphere(0.05)]
    assert [v.colour for v in base.visuals] == [(0, 0, 1, 1), None]
    assert base.collisions[0].geometry == Cylinder(0.1, 0.5)
    assert (base.inertial.mass, base.inertial.inertia) == (2, (1, 0, 0, 2, 0, 3))
    assert camera.visuals[0].geometry == Mesh('package://somewhere/camera.stl', (1, 2, 3))
    assert camera.visuals[0].colour == (1, 0, 0, 0.5)
    shoulder = arm.joints['shoulder']
    assert (shoulder.axis, shoulder.limit.lower, shoulder.soft_limits) == ((0, 1, 0), 0.5, (0.7, None))
    assert arm.joints['grip'].mimic == Mimic('shoulder', -2, 0.25)
    assert arm.joints['grip'].axis == (0, 0, 1) and arm.joints['camera_joint'].axis == (1, 0, 0)


def test_poses():
    """The numbers are worked out by hand: a quarter turn about z takes x to y."""
    origin = read(ARM).links['base'].visuals[0].origin
    assert origin.matrix @ [1, 0, 0, 1] == pytest.approx([0, 1, 0.1, 1])
    # Roll, pitch, yaw about fixed axes: x goes by pitch to -z, and yaw leaves that; y by roll to z, by pitch to x.
    turned = read(robot(joint(inside='<origin rpy="1.57079632679 1.57079632679 0.3"/>'))).joints['j'].origin
    assert turned.matrix[:3, 0] == pytest.approx([0, 0, -1], abs=1e-9)
    assert turned.matrix[:3, 1] == pytest.approx([math.cos(0.3), math.sin(0.3), 0], abs=1e-9)
    assert numpy.linalg.norm(turned.quaternion) == pytest.approx(1)


def test_joints_move_their_links():
    arm = read(ARM)
    translation, rotation = arm.joints['shoulder'].transform(math.pi / 2)
    # Quarter turns about z, then about the new y: (1, 1, 1, 1) / 2 up to the sign of x.
    assert translation == (0, 0, 1) and rotation == pytest.approx((-0.5, 0.5, 0.5, 0.5))
    translation, rotation = arm.joints['lift'].transform(0.4)
    assert translation == pytest.approx((0.4, 0, 0)) and rotation == arm.joints['lift'].origin.quaternion
    assert arm.joints['camera_joint'].transform(9.0) == ((0.1, 0, 0.2), (0, 0, 0, 1))


@pytest.mark.parametrize(
    ('text', 'problem'),
    [
        (' \n', 'the robot description is empty'),
        ('<robot name="r">\n<link name="a">\n</robot>', 'line 3: this is no XML: mismatched tag'),
        ('/tmp/robot.urdf', 'line 1: this is no XML: not well-formed'),
        ('<model/>', 'line 1: a robot description begins with <robot>, this one with <model>'),
        ('<robot>\n<link name="a"/></robot>', 'line 1: <robot> has no name'),
        ('<robot name="r"/>', 'the robot has no <link>'),
        ('<robot name="r">\n<link/></robot>', 'line 2: <link> has no name'),
        (robot('<link name="a"/>'), "line 4: there are two links 'a'"),
        (robot(joint(), joint(child='a')), "line 5: there are two joints 'j'"),
        (robot(joint('hinge')), "line 4: joint 'j': its type is 'hinge'; there are revolute"),
        (robot('<joint name="j" type="fixed"><parent link="a"/></joint>'), "joint 'j': it has no <child link="),
        (
            robot(joint(child='laser')),
            "line 4: joint 'j': its child 'laser' is no link of this robot; correct the name or "
            'add <link name="laser"/>',
        ),
        (robot(joint(parent='base')), "line 4: joint 'j': its parent 'base' is no link"),
        (
            robot(joint(), '<link name="c"/>', joint(name='k', parent='c')),
            "link 'b' has two parents, by the joints 'j'",
        ),
        (robot(), "the links 'a' and 'b' both have no parent; a robot has one root"),
        (robot(joint(), joint(name='k', parent='b', child='a')), 'every link has a parent: the joints make a loop'),
        (robot(joint(child='a')), 'the links a make a loop'),
        (robot(joint('revolute')), "joint 'j': a revolute joint needs a <limit>"),
        (robot(joint('prismatic', '<limit lower="0" upper="1"/>')), "joint 'j': <limit> has no effort"),
        (robot(joint('continuous', '<axis xyz="0 0 0"/>')), "joint 'j': its axis is 0 0 0"),
        (
            robot(joint(inside='<origin xyz="0, 0, 1"/>')),
            'xyz="0, 0, 1" of <origin> must be 3 numbers with spaces between',
        ),
        (robot(joint(inside='<origin xyz="0 0"/>')), 'xyz="0 0" of <origin> must be 3 numbers'),
        (robot(joint(inside='<origin xyz="0 0 nan"/>')), 'must be 3 numbers'),
        (robot(joint('continuous', '<mimic joint="k"/>')), "joint 'j': it mimics 'k', which is no joint"),
        ('<robot name="r"><link name="a"><visual/></link></robot>', "link 'a': <visual> has no <geometry>"),
        (
            '<robot name="r"><link name="a"><visual><geometry><cone/></geometry></visual></link></robot>',
            "link 'a': <cone> is no shape; there are box, cylinder, sphere and mesh",
        ),
        (
            '<robot name="r"><link name="a"><collision><geometry><sphere/></geometry></collision></link></robot>',
            "link 'a': <sphere> has no radius",
        ),
        (
            '<robot name="r"><link name="a"><visual><geometry><sphere radius="1"/></geometry>'
            '<material name="red"/></visual>'
            '</link></robot>',
            'link \'a\': there is no <material name="red"> with a <color>',
        ),
        (
            '<robot name="r"><link name="a"><inertial><mass value="1"/></inertial></link></robot>',
            "link 'a': <inertial> has no <inertia>",
        ),
    ],
)
def test_bad_descriptions(text, problem):
    with pytest.raises(UrdfError) as error:
        read(text)
    assert problem in str(error.value) and '\n' not in str(error.value)


def test_limits_are_needed_only_where_they_mean_something():
    assert read(robot(joint('revolute', LIMIT))).joints['j'].limit.upper == 1
    assert read(robot(joint('floating'))).joints['j'].limit is None


def test_files_of_meshes(tmp_path):
    mesh = tmp_path / 'a wheel.stl'
    mesh.touch()
    assert resolve(str(mesh)) == resolve(f'file://{tmp_path}/a%20wheel.stl') == mesh
    assert resolve('package://urdf_reader/package.xml').name == 'package.xml'
    for name, problem in [
        ('package://nowhere/a.stl', "there is no package 'nowhere'"),
        ('package://urdf_reader/a.stl', 'there is no file'),
        ('meshes/a.stl', 'package://PACKAGE/path or by an absolute path'),
        ('https://example.org/a.stl', 'cannot read https://'),
    ]:
        with pytest.raises(UrdfError, match=problem):
            resolve(name)


def test_a_robot_within_another_element_is_read_only_if_asked_for():
    text = '<scene><robot name="inner"><link name="base"/></robot></scene>'
    assert read(text, nested=True).name == 'inner'
    with pytest.raises(UrdfError, match='begins with <robot>'):
        read(text)
    with pytest.raises(UrdfError, match='begins with <robot>'):
        read('<scene><link name="base"/></scene>', nested=True)
