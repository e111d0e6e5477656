"""A world as ROS messages: what is published, of which type, how often, and when it is due."""

from array import array  # rclpy takes it as it is, and checks the elements of anything else one by one
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from math import cos, sin, tan

import mujoco
import numpy
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point, Pose, Quaternion, TransformStamped, Vector3
from nav_msgs.msg import Odometry
from rclpy.qos import DurabilityPolicy, QoSProfile
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, Image, JointState, LaserScan
from std_msgs.msg import ColorRGBA, Header
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from mujoco_world.world import CONTROL_PERIOD, World

MAP = 'map'
PERIOD = 0.02  # s, of /clock, /odom, /tf and /joint_states: 50 a second
QOS = QoSProfile(depth=10)
TF_QOS = QoSProfile(depth=100)
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@dataclass(frozen=True)
class Topic:
    """A topic that the world publishes on.

    :param ticks: control periods from one message to the next.
    :param make: gives the message; it is called at a time when it is due.
    """

    name: str
    type: type
    ticks: int
    make: Callable[[], object]
    qos: QoSProfile = field(default_factory=lambda: QOS)


class Topics:
    """
    The topics of a world with its robot; sensors that the robot does not have are left out.

    Stamps are simulated time. Frames are those of REP 105: map -> odom -> the drive's base frame; the robot's own
    frames come from robot_state_publisher.

    :param localization: publish map -> odom, as a perfect localiser would.
    """

    def __init__(self, world: World, localization: bool = True):
        self.world = world
        self.localization = localization
        robot = world.robot
        often = round(PERIOD / CONTROL_PERIOD)
        found = [Topic('/clock', Clock, often, lambda: Clock(clock=self.now()))]
        if robot.drive:
            found.append(Topic('odom', Odometry, often, self.odometry))
        found.append(Topic('/tf', TFMessage, often, self.transforms, TF_QOS))
        found.append(Topic('joint_states', JointState, often, self.joint_states))
        if robot.lidar:
            found.append(Topic('scan', LaserScan, _ticks(robot.lidar.rate), self.scan))
        if robot.camera:
            found.append(Topic('camera_info', CameraInfo, _ticks(robot.camera.rate), self.camera_info))
            found.append(Topic('image', Image, _ticks(robot.camera.rate), self.image))
        self.topics = tuple(found)

    def due(self) -> Iterator[Topic]:
        """The topics that have a message now; ``make`` it before the world goes on. ``/clock`` comes first."""
        return (topic for topic in self.topics if self.world.ticks % topic.ticks == 0)

    def now(self) -> Time:
        """Simulated time."""
        nanoseconds = round(self.world.ticks * CONTROL_PERIOD * 1e9)
        return Time(sec=nanoseconds // 10**9, nanosec=nanoseconds % 10**9)

    def odometry(self) -> Odometry:
        """Where the wheels say that the robot is, and its velocity, in the frame of its base."""
        drive, believed = self.world.robot.drive, self.world.odometry
        message = Odometry(header=self._header(drive.odom_frame), child_frame_id=drive.base_frame)
        message.pose.pose = Pose(position=Point(x=believed.x, y=believed.y), orientation=_turn(believed.yaw))
        message.twist.twist.linear.x, message.twist.twist.angular.z = believed.linear, believed.angular
        return message

    def transforms(self) -> TFMessage:
        """odom -> base from the wheels, and map -> odom such that map -> base is true."""
        drive, world = self.world.robot.drive, self.world
        truth = world.transform(world.robot.description.root)
        if drive is None:  # nothing that could be wrong: the root's own frame, as it is
            return TFMessage(transforms=[_transform(self._header(MAP), world.robot.description.root, truth)])
        believed = world.odometry
        c, s = cos(believed.yaw), sin(believed.yaw)
        base = numpy.array([[c, -s, 0, believed.x], [s, c, 0, believed.y], [0, 0, 1, 0], [0, 0, 0, 1.0]])
        found = [_transform(self._header(drive.odom_frame), drive.base_frame, base)]
        if self.localization:
            truth = world.transform(drive.base_frame)
            found.insert(0, _transform(self._header(MAP), drive.odom_frame, truth @ numpy.linalg.inv(base)))
        return TFMessage(transforms=found)

    def joint_states(self) -> JointState:
        """Positions and velocities of the joints that move."""
        joints = self.world.joints
        return JointState(
            header=self._header(''),
            name=list(joints),
            position=[one for one, _ in joints.values()],
            velocity=[one for _, one in joints.values()],
        )

    def scan(self) -> LaserScan:
        """One turn of the laser, as if all its rays went out at once."""
        lidar = self.world.robot.lidar
        return LaserScan(
            header=self._header(lidar.frame),
            angle_min=lidar.min_angle,
            angle_max=lidar.max_angle,
            angle_increment=lidar.increment,
            scan_time=1 / lidar.rate,
            range_min=lidar.min_range,
            range_max=lidar.max_range,
            ranges=array('f', self.world.scan().tobytes()),
        )

    def image(self) -> Image:
        """What the camera sees. Raises NoPicturesError where the machine cannot render."""
        camera = self.world.robot.camera
        return Image(
            header=self._header(camera.frame),
            height=camera.height,
            width=camera.width,
            encoding='rgb8',
            step=3 * camera.width,
            data=array('B', self.world.image().tobytes()),
        )

    def camera_info(self) -> CameraInfo:
        """The camera's intrinsics: a pinhole in the middle of the picture, square pixels, no distortion."""
        camera = self.world.robot.camera
        focal = camera.width / 2 / tan(camera.fov / 2)  # pixels
        x, y = camera.width / 2, camera.height / 2
        return CameraInfo(
            header=self._header(camera.frame),
            height=camera.height,
            width=camera.width,
            distortion_model='plumb_bob',
            d=[0.0] * 5,
            k=[focal, 0.0, x, 0.0, focal, y, 0.0, 0.0, 1.0],
            r=[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
            p=[focal, 0.0, x, 0.0, 0.0, focal, y, 0.0, 0.0, 0.0, 1.0, 0.0],
        )

    def markers(self) -> MarkerArray:
        """The scene, for a view: floor, walls, stations and their names, in the frame map."""
        scene = self.world.scene
        ends = [
            [wall.at[axis] + sign * wall.size[axis] / 2 for wall in scene.walls for sign in (-1, 1)] or [-2.0, 2.0]
            for axis in (0, 1)
        ]
        middle = [(min(one) + max(one)) / 2 for one in ends]
        sides = [max(one) - min(one) + 0.6 for one in ends]
        found = [_marker('floor', Marker.CUBE, (*middle, -0.01), (*sides, 0.02), (0.90, 0.90, 0.88, 0.6))]
        found += [
            _marker('walls', Marker.CUBE, (*wall.at, wall.height / 2), (*wall.size, wall.height), wall.colour)
            for wall in scene.walls
        ]
        for name, (x, y, _) in scene.stations.items():
            colour = scene.colours.get(name, (0.45, 0.47, 0.52, 1.0))
            found.append(_marker('stations', Marker.CYLINDER, (x, y, 0.01), (0.44, 0.44, 0.02), colour))
            found.append(
                _marker('names', Marker.TEXT_VIEW_FACING, (x, y, 0.35), (0, 0, 0.2), (0.1, 0.1, 0.1, 1.0), name)
            )
        for number, marker in enumerate(found):
            marker.id = number
        return MarkerArray(markers=found)

    def _header(self, frame: str) -> Header:
        return Header(stamp=self.now(), frame_id=frame)


def _ticks(rate: float) -> int:
    return max(1, round(1 / rate / CONTROL_PERIOD))


def _turn(yaw: float) -> Quaternion:
    return Quaternion(z=sin(yaw / 2), w=cos(yaw / 2))


def _transform(header: Header, child: str, matrix: numpy.ndarray) -> TransformStamped:
    """A rigid 4x4 matrix, child to parent, as a message."""
    quaternion = numpy.empty(4)
    mujoco.mju_mat2Quat(quaternion, matrix[:3, :3].ravel())
    w, x, y, z = quaternion.tolist()
    message = TransformStamped(header=header, child_frame_id=child)
    message.transform.translation = Vector3(**dict(zip('xyz', matrix[:3, 3].tolist(), strict=True)))
    message.transform.rotation = Quaternion(x=x, y=y, z=z, w=w)
    return message


def _marker(kind: str, shape: int, at, size, colour, text: str = '') -> Marker:
    """A marker that never ends. `at` is its centre, `size` its extents, in metres."""
    marker = Marker(header=Header(frame_id=MAP), ns=kind, type=shape, text=text)
    marker.pose.position = Point(**dict(zip('xyz', map(float, at), strict=True)))
    marker.pose.orientation.w = 1.0
    marker.scale = Vector3(**dict(zip('xyz', map(float, size), strict=True)))
    marker.color = ColorRGBA(**dict(zip('rgba', map(float, colour), strict=True)))
    return marker
