"""Displays without a renderer: which shapes, where, and what the status says. The messages are handed to them."""

import math

import numpy as np
import pytest
from builtin_interfaces.msg import Time as Stamp
from geometry_msgs.msg import Point, TransformStamped
from nav_msgs.msg import Odometry as OdometryMsg
from rclpy.time import Time
from sensor_msgs.msg import LaserScan as LaserScanMsg
from sensor_msgs.msg import PointCloud2 as PointCloud2Msg
from sensor_msgs.msg import PointField
from sensor_msgs_py import point_cloud2
from std_msgs.msg import ColorRGBA, Header, String
from tf2_ros import Buffer
from visualization_msgs.msg import Marker as MarkerMsg
from visualization_msgs.msg import MarkerArray as MarkerArrayMsg

from helpers.show.views import LaserScan, Marker, MarkerArray, Odometry, PointCloud2, RobotModel, Text
from helpers.show.views.display import Display
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import Arrow, Box, Cylinder, Label, Line, Mesh, Points, Sphere

LATEST = Time()
S = 1_000_000_000


class Stage:
    """One display with a scene, a buffer and a node, as a view has them."""

    def __init__(self, display, node):
        self.display, self.scene, self.buffer = display, Scene(), Buffer()
        display.start(node, self.buffer, self.scene)

    def frame(self, parent: str, child: str, x: float = 0.0, at: float = 0.0, static: bool = False) -> None:
        message = TransformStamped(child_frame_id=child)
        message.header.frame_id, message.header.stamp = parent, stamp(at)
        message.transform.translation.x, message.transform.rotation.w = x, 1.0
        (self.buffer.set_transform_static if static else self.buffer.set_transform)(message, 'test')

    def update(self, fixed_frame: str = 'odom', at: float = 0.0) -> str:
        """Update as a view does; return the status."""
        self.display.refresh(fixed_frame, Time(nanoseconds=round(at * S)))
        return self.display.status()

    def seen(self) -> dict:
        """What is to be seen: path -> Item."""
        return {item.path: item for item in self.scene.items()}


def stamp(seconds: float) -> Stamp:
    return Stamp(sec=int(seconds), nanosec=round(seconds % 1 * S))


@pytest.fixture
def stage(ros):
    import rclpy

    nodes, displays = [], []

    def make(display) -> Stage:
        if not nodes:
            nodes.append(rclpy.create_node('stage'))
        displays.append(display)
        return Stage(display, nodes[0])

    yield make
    for display in displays:
        display.stop()


def test_a_problem_is_told_until_an_update_has_ended_without_it():
    asked = []

    class Asked(Display):
        def update(self, fixed_frame, time):
            asked.append((self.problem, self.status()))
            self.problem = next(problems)

    one, problems = Asked(), iter(('no scan', 'no scan', ''))
    for _ in range(3):
        one.refresh('map', Time())
    assert asked == [('', ''), ('', 'no scan'), ('', 'no scan')] and one.status() == ''


# Texts


def test_a_text_stands_above_its_frame(stage):
    one = stage(Text('/status', 'robot', above=0.5))
    one.update()
    assert not one.seen()
    one.display.take(String(data='idle'))
    assert 'robot' in one.update() and not one.seen()
    one.frame('odom', 'robot', x=2.0, static=True)
    assert one.update() == ''
    (item,) = one.seen().values()
    assert item.shape.text == 'idle' and item.pose[:3, 3] == pytest.approx([2.0, 0.0, 0.5])
    one.display.take(String(data='driving to gate'))
    one.update()
    (item,) = one.seen().values()
    assert item.shape.text == 'driving to gate'


# Laser scans


def scan(at: float = 0.0, ranges=(1.0, 2.0, 3.0), **more) -> LaserScanMsg:
    message = LaserScanMsg(
        angle_min=0.0, angle_increment=math.pi / 2, range_min=0.5, range_max=10.0, ranges=list(ranges), **more
    )
    message.header.frame_id, message.header.stamp = 'laser', stamp(at)
    return message


def test_scan_points():
    points = LaserScan().points(scan(ranges=(1.0, 2.0, 0.4, 10.5, math.inf, math.nan, 4.0)))
    assert points == pytest.approx(np.array([[1, 0, 0], [0, 2, 0], [-4, 0, 0]]), abs=1e-5)
    assert points.dtype == np.float32
    assert len(LaserScan().points(scan(ranges=()))) == 0


def test_scan_is_placed_by_the_transform_of_its_time_and_stays(stage):
    s = stage(LaserScan())
    s.frame('odom', 'laser', x=0.0, at=10.0)
    s.frame('odom', 'laser', x=1.0, at=11.0)
    s.display.receive(scan(10.5))
    assert s.update() == ''
    item = s.seen()['message']
    assert isinstance(item.shape, Points) and item.pose[:3, 3] == pytest.approx([0.5, 0, 0])
    s.frame('odom', 'laser', x=9.0, at=12.0)
    s.update()
    assert s.seen()['message'].pose[0, 3] == pytest.approx(0.5)
    s.display.receive(scan(12.0))
    s.update()
    assert s.seen()['message'].pose[0, 3] == pytest.approx(9.0)
    assert s.update('laser') == '' and s.seen()['message'].pose[0, 3] == 0.0


def test_scan_waits_for_its_transform_while_the_last_one_is_shown(stage, monkeypatch):
    clock = [100.0]
    monkeypatch.setattr('helpers.show.views.topic_display.time.monotonic', lambda: clock[0])
    s = stage(LaserScan())
    s.frame('odom', 'laser', x=1.0, at=10.0)
    s.display.receive(scan(10.0))
    s.update()
    s.display.receive(scan(10.2))
    assert s.update() == '' and s.seen()['message'].pose[0, 3] == 1.0
    clock[0] += 1.0
    assert s.update() == 'no transform from [laser] to [odom] at the time of the message on [/scan]'
    assert s.seen() == {}
    s.frame('odom', 'laser', x=2.0, at=10.2)
    assert s.update() == '' and s.seen()['message'].pose[0, 3] == 2.0


def test_of_many_messages_the_newest_with_a_transform_is_shown(stage):
    """As on a busy machine, where transforms are a second behind."""
    s = stage(LaserScan())
    s.frame('odom', 'laser', x=0.0, at=10.0)
    s.frame('odom', 'laser', x=1.0, at=10.2)
    for step in range(50):
        s.display.receive(scan(10.0 + 0.02 * step))
    assert s.update() == '' and s.seen()['message'].pose[0, 3] == pytest.approx(1.0)


def test_scan_time_travel(stage):
    s = stage(LaserScan())
    for second in range(5):
        s.frame('odom', 'laser', x=float(second), at=10.0 + second)
        s.display.receive(scan(10.0 + second, ranges=[1.0] * (second + 1)))
    s.update()
    assert len(s.seen()['message'].shape.points) == 5
    s.update(at=12.5)
    assert (len(s.seen()['message'].shape.points), s.seen()['message'].pose[0, 3]) == (3, 2.0)
    s.display.receive(scan(100.0))  # the past stays while one looks at it
    s.update(at=12.5)
    assert len(s.seen()['message'].shape.points) == 3
    s.update(at=9.0)
    assert s.seen() == {}
    s.frame('odom', 'laser', at=100.0)
    s.update()
    assert len(s.seen()['message'].shape.points) == 3 == len(scan().ranges)
    s.display.receive(scan(101.0))
    assert len(s.display._kept) == 2


def test_scan_with_a_frame_that_is_not_there(stage):
    s = stage(LaserScan())
    s.frame('odom', 'base')
    s.display.receive(scan())
    assert s.update() == 'no transform from [laser] to [odom]' and s.seen() == {}
    assert s.update('') == 'no transform from [laser]: no frames'
    assert s.update('laser') == '' and 'message' in s.seen()
    nameless = scan()
    nameless.header.frame_id = ''
    s.display.receive(nameless)
    assert s.update() == 'the message on [/scan] has no frame_id'


def test_scan_after_the_clock_went_back(stage):
    s = stage(LaserScan())
    s.frame('odom', 'laser', static=True)
    s.display.receive(scan(500.0))
    s.display.receive(scan(1.0, ranges=[1.0]))
    s.update()
    assert len(s.seen()['message'].shape.points) == 1


# Point clouds


def test_cloud_colours():
    display = PointCloud2()
    data = np.zeros(3, dtype=[('x', 'f4'), ('rgb', 'f4'), ('intensity', 'f4')])
    data['rgb'] = np.array([0xFF0000, 0x00FF00, 0x0000FF], dtype=np.uint32).view(np.float32)
    data['intensity'] = [10, 20, 30]
    fields = {'x', 'rgb', 'intensity'}
    assert display._colours(data, fields) == pytest.approx(np.eye(3))
    low, middle, high = PointCloud2(colour='intensity')._colours(data, fields)
    assert low.argmax() == 2 and middle.argmax() == 1 and high.argmax() == 0  # blue, green, red
    assert PointCloud2(colour=(1, 0, 0))._colours(data, fields).tolist() == [1, 0, 0]


def test_cloud_is_read_and_thinned_out(stage):
    points = [(float(i), 0.0, math.nan if i == 4 else 1.0) for i in range(10)]
    s = stage(PointCloud2(most=5))
    s.frame('odom', 'camera', x=1.0, static=True)
    s.display.receive(point_cloud2.create_cloud_xyz32(Header(frame_id='camera'), points))
    assert s.update() == ''
    item = s.seen()['message']
    shown = set(item.shape.points[:, 0].tolist())
    assert 4 <= len(shown) <= 5 and shown < set(range(10)) - {4}
    assert item.pose[0, 3] == 1.0 and len(item.shape.colours) == len(shown)


def test_cloud_without_the_fields_that_it_needs(stage):
    s = stage(PointCloud2(colour='ring'))
    s.frame('odom', 'camera', static=True)
    s.display.receive(point_cloud2.create_cloud_xyz32(Header(frame_id='camera'), [(1.0, 2.0, 3.0)]))
    assert s.update() == "the cloud on [/points] has no field 'ring'; it has x, y, z"
    s.display.receive(PointCloud2Msg(header=Header(frame_id='camera'), fields=[PointField(name='r', count=1)]))
    assert s.update() == 'the cloud on [/points] has no fields x, y, z' and s.seen() == {}


# Odometry


def odometry(x: float, at: float, heading: float = 0.0) -> OdometryMsg:
    message = OdometryMsg(child_frame_id='base')
    message.header.frame_id, message.header.stamp = 'odom', stamp(at)
    message.pose.pose.position.x = x
    message.pose.pose.orientation.z = math.sin(heading / 2)
    message.pose.pose.orientation.w = math.cos(heading / 2)
    return message


def test_odometry_path_and_arrow(stage):
    s = stage(Odometry(length=0.3))
    s.frame('map', 'odom', x=5.0, static=True)
    for number in range(101):
        s.display.receive(odometry(number / 100, 1.0 + number / 100))
    s.display.receive(odometry(1.0, 3.0, heading=math.pi / 2))
    assert s.update('map') == ''
    path, arrow = s.seen()['message/path'], s.seen()['message/arrow']
    assert isinstance(path.shape, Line) and 34 <= len(path.shape.points) <= 52
    assert path.shape.points[-1].tolist() == [1, 0, 0] and path.pose[0, 3] == 5.0
    assert isinstance(arrow.shape, Arrow) and arrow.pose[:3, 0] == pytest.approx([0, 1, 0])
    assert arrow.pose[:3, 3] == pytest.approx([6, 0, 0])
    s.update('map', at=1.5)
    assert s.seen()['message/path'].shape.points[:, 0].max() <= 0.5
    assert s.seen()['message/arrow'].pose[0, 3] == pytest.approx(5.5)


def test_odometry_keeps_so_much(stage):
    s = stage(Odometry(keep=10))
    for number in range(30):
        s.display.receive(odometry(float(number), 1.0 + number))
    assert [x for x, _, _ in s.display.path] == list(range(20, 30))


# Robots


ROBOT = """
<robot name="cart">
  <link name="base">
    <visual><origin xyz="0 0 0.1"/><geometry><box size="1 2 3"/></geometry>
      <material name="m"><color rgba="1 0 0 0.5"/></material></visual>
    <visual><geometry><sphere radius="0.5"/></geometry></visual>
    <collision><geometry><cylinder radius="0.2" length="0.4"/></geometry></collision>
  </link>
  <link name="wheel"><visual><geometry><mesh filename="{mesh}" scale="0.1 0.1 0.1"/></geometry></visual></link>
  <joint name="axle" type="continuous"><parent link="base"/><child link="wheel"/></joint>
</robot>
"""
TETRAHEDRON = (
    'solid t\n'
    + '\n'.join(
        f'facet normal 0 0 0\nouter loop\n{corners}\nendloop\nendfacet'
        for corners in (
            'vertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0',
            'vertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1',
            'vertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0',
            'vertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1',
        )
    )
    + '\nendsolid t\n'
)


@pytest.fixture
def mesh_file(tmp_path):
    path = tmp_path / 'wheel.stl'
    path.write_text(TETRAHEDRON)
    return path


def test_robot_each_link_where_tf_says(stage, mesh_file):
    s = stage(RobotModel(prefix='left/'))
    s.display.receive(String(data=ROBOT.format(mesh=mesh_file)))
    s.frame('odom', 'left/base', x=2.0)
    assert s.update() == 'no transform from [left/wheel] to [odom]'
    assert set(s.seen()) == {'base/0', 'base/1'}
    s.frame('left/base', 'left/wheel', x=1.0)
    assert s.update() == ''
    seen = s.seen()
    assert seen['base/0'].shape == Box((1, 2, 3), (1, 0, 0)) and seen['base/0'].opacity == 0.5
    assert seen['base/0'].pose[:3, 3] == pytest.approx([2, 0, 0.1])
    assert isinstance(seen['base/1'].shape, Sphere)
    wheel = seen['wheel/0']
    assert isinstance(wheel.shape, Mesh) and wheel.shape.faces.shape == (4, 3)
    assert wheel.pose == pytest.approx(np.array([[0.1, 0, 0, 3], [0, 0.1, 0, 0], [0, 0, 0.1, 0], [0, 0, 0, 1]]))
    assert s.display.robot.name == 'cart'


def test_robot_collision_shapes(stage, mesh_file):
    s = stage(RobotModel(collision=True, opacity=0.4))
    s.display.receive(String(data=ROBOT.format(mesh=mesh_file)))
    s.frame('odom', 'base')
    assert s.update() == ''
    assert [(item.shape.radius, item.opacity) for item in s.seen().values()] == [(0.2, 0.4)]


def test_robot_a_new_description_replaces_the_old_one(stage, tmp_path):
    s = stage(RobotModel())
    s.frame('odom', 'base')
    s.frame('odom', 'wheel')
    s.display.receive(String(data=ROBOT.format(mesh='package://nowhere/wheel.stl')))
    assert s.update().startswith("link [wheel]: package://nowhere/wheel.stl: there is no package 'nowhere'")
    assert 'base/0' in s.seen()
    (tmp_path / 'bad.stl').write_text('no mesh')
    s.display.receive(String(data=ROBOT.format(mesh=tmp_path / 'bad.stl')))
    assert 'bad.stl: ' in s.update()
    s.display.receive(String(data='<robot name="r"><link name="base"/></robot>'))
    assert s.update() == 'no link of robot [r] has a <visual>' and s.seen() == {}
    s.display.receive(String(data='<robot name="r">'))
    assert s.update().startswith('bad robot description: line 1: this is no XML') and s.display.robot is None


# Markers


def marker(kind: int = MarkerMsg.CUBE, number: int = 0, at: float = 0.0, **fields) -> MarkerMsg:
    message = MarkerMsg(**{'ns': 'n', 'id': number, 'type': kind, 'color': ColorRGBA(r=1.0, a=1.0), **fields})
    message.header.frame_id, message.header.stamp = 'map', stamp(at)
    message.scale.x, message.scale.y, message.scale.z = 0.1, 0.2, 0.3
    message.pose.position.x = 1.0
    return message


POINTS = [Point(x=0.0), Point(x=1.0), Point(x=1.0, y=1.0)]


@pytest.mark.parametrize(
    ('message', 'kind', 'scale'),
    [
        (marker(MarkerMsg.CUBE), Box, (0.1, 0.2, 0.3)),
        (marker(MarkerMsg.SPHERE), Sphere, (0.1, 0.2, 0.3)),
        (marker(MarkerMsg.CYLINDER), Cylinder, (0.1, 0.2, 0.3)),
        (marker(MarkerMsg.ARROW), Arrow, (1, 1, 1)),
        (marker(MarkerMsg.LINE_STRIP, points=POINTS), Line, (1, 1, 1)),
        (marker(MarkerMsg.LINE_LIST, points=POINTS[:2]), Line, (1, 1, 1)),
        (marker(MarkerMsg.POINTS, points=POINTS), Points, (1, 1, 1)),
        (marker(MarkerMsg.TEXT_VIEW_FACING, text='dock'), Label, (1, 1, 1)),
        (marker(MarkerMsg.TRIANGLE_LIST, points=POINTS), Mesh, (0.1, 0.2, 0.3)),
    ],
    ids=lambda value: getattr(value, '__name__', ''),
)
def test_marker_types(stage, message, kind, scale):
    s = stage(Marker())
    s.frame('odom', 'map', x=10.0, static=True)
    s.display.receive(message)
    assert s.update() == ''
    item = s.seen()['n/0/0']
    assert isinstance(item.shape, kind)
    assert item.pose[:3, 3] == pytest.approx([11, 0, 0])
    assert np.diag(item.pose)[:3] == pytest.approx(scale)


def test_marker_lists_are_single_shapes_while_they_are_few(stage):
    s = stage(Marker())
    s.frame('odom', 'map', static=True)
    colours = [ColorRGBA(r=1.0, a=1.0), ColorRGBA(g=1.0, a=1.0), ColorRGBA(b=1.0, a=1.0)]
    s.display.receive(marker(MarkerMsg.CUBE_LIST, points=POINTS, colors=colours))
    s.update()
    assert [item.shape for item in s.seen().values()] == [Box((1, 1, 1), c) for c in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    s.display.receive(marker(MarkerMsg.SPHERE_LIST, points=POINTS[:1]))
    s.update()
    assert [type(item.shape) for item in s.seen().values()] == [Sphere]  # no cube is left over
    s.display.receive(marker(MarkerMsg.CUBE_LIST, points=POINTS * 100))
    s.update()
    assert [len(item.shape.points) for item in s.seen().values()] == [300]


def test_marker_arrow_between_two_points(stage):
    s = stage(Marker())
    s.frame('odom', 'map', static=True)
    for end, x in ((Point(x=1.0, z=2.0), (0, 0, 1)), (Point(y=2.0), (-1 / math.sqrt(5), 2 / math.sqrt(5), 0))):
        message = marker(MarkerMsg.ARROW, points=[Point(x=1.0), end])
        message.pose.position.x = 0.0
        s.display.receive(message)
        s.update()
        item = s.seen()['n/0/0']
        assert item.pose[:3, 0] == pytest.approx(x) and item.pose[:3, 3] == pytest.approx([1, 0, 0])
        assert np.linalg.det(item.pose) == pytest.approx(1)


def test_marker_delete_lifetime_and_array(stage, monkeypatch):
    clock = [100.0]
    monkeypatch.setattr('helpers.show.views.marker.time.monotonic', lambda: clock[0])
    s = stage(MarkerArray())
    s.frame('odom', 'map', static=True)
    short = marker(number=2)
    short.lifetime.nanosec = S // 2
    other = marker(number=3)
    other.ns = 'other'
    s.display.receive(MarkerArrayMsg(markers=[marker(number=0), marker(number=1), short, other]))
    s.update()
    assert s.display.markers == [('n', 0), ('n', 1), ('n', 2), ('other', 3)] and len(s.seen()) == 4
    s.display.receive(MarkerArrayMsg(markers=[marker(number=0, action=MarkerMsg.DELETE)]))
    clock[0] += 0.6
    s.update()
    assert s.display.markers == [('n', 1), ('other', 3)] and len(s.seen()) == 2
    s.display.receive(MarkerArrayMsg(markers=[marker(action=MarkerMsg.DELETEALL)]))
    s.update()
    assert s.display.markers == [('other', 3)]


def test_marker_stays_in_the_fixed_frame_unless_locked(stage):
    s = stage(Marker())
    s.frame('odom', 'map', x=1.0, at=1.0)
    s.display.receive(marker(number=0))
    s.display.receive(marker(number=1, frame_locked=True))
    s.update()
    s.frame('odom', 'map', x=5.0, at=2.0)
    s.update()
    assert [s.seen()[f'n/{number}/0'].pose[0, 3] for number in (0, 1)] == [2.0, 6.0]
    s.display.receive(marker(number=0, at=9.0))
    assert s.update() == 'no transform from [map] to [odom] at the time of the marker'


@pytest.mark.parametrize(
    ('message', 'says'),
    [
        (marker(color=ColorRGBA(r=1.0)), 'marker [n/0]: its color has alpha 0, so nobody sees it; set color.a to 1'),
        (marker(MarkerMsg.LINE_LIST, points=POINTS), 'marker [n/0]: a LINE_LIST needs an even number of points, not 3'),
        (marker(MarkerMsg.POINTS, points=POINTS, colors=[ColorRGBA(a=1.0)] * 2), 'it has 3 points, but 2 colors'),
        (marker(MarkerMsg.MESH_RESOURCE), 'its mesh_resource is empty; it must name a file'),
        (marker(MarkerMsg.MESH_RESOURCE, mesh_resource='package://nowhere/a.stl'), "there is no package 'nowhere'"),
        (marker(77), 'type 77 is not shown here'),
    ],
    ids=['alpha', 'odd', 'colours', 'no mesh', 'package', 'type'],
)
def test_marker_that_makes_no_sense(stage, message, says):
    s = stage(Marker())
    s.frame('odom', 'map', static=True)
    s.display.receive(message)
    assert says in s.update()


def test_marker_without_size(stage):
    s = stage(Marker())
    s.frame('odom', 'map', static=True)
    message = marker()
    message.scale.y = 0.0
    s.display.receive(message)
    assert s.update() == 'marker [n/0]: its scale is 0.1, 0, 0.3; it must be above 0'
