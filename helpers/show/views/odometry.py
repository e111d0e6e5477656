"""The display of odometry: where the robot is, and the path that it took."""

import math

from helpers.show.views import poses
from helpers.show.views.shapes import BLUE, Arrow, Line
from helpers.show.views.topic_display import StampedDisplay

_STEP, _TURN = 0.02, 0.1  # m and rad between two points of the path


class Odometry(StampedDisplay):
    """An arrow at the robot's pose along its x axis, and its path (nav_msgs/Odometry).

    :param topic: name of the topic.
    :param colour: red, green, blue from 0 to 1.
    :param length: of the arrow in m; 0: the path only.
    :param keep: points of the path, at most; the oldest go first.
    :param qos: QoS or depth; None: as in RViz, reliable.
    """

    def __init__(self, topic: str = '/odom', colour=BLUE, length: float = 0.4, keep: int = 2000, qos=None):
        super().__init__(topic, qos)
        self.colour, self.length, self.keep = colour, length, keep
        self._path: list[tuple[int, tuple]] = []  # (stamp, position)
        self._heading = 0.0
        self._drawn: tuple = ()

    def message_type(self):
        from nav_msgs.msg import Odometry

        return Odometry

    def on_start(self) -> None:
        super().on_start()
        self._path, self._drawn = [], ()

    @property
    def path(self) -> list[tuple[float, float, float]]:
        """The positions so far in the frame of the messages, in m, at least 2 cm or 0.1 rad apart."""
        return [position for _, position in self._path]

    def take(self, message) -> None:
        super().take(message)
        stamp = message.header.stamp.sec * 1_000_000_000 + message.header.stamp.nanosec
        pose = message.pose.pose
        here = (pose.position.x, pose.position.y, pose.position.z)
        q = pose.orientation
        heading = math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))
        if self._path and stamp < self._path[-1][0]:  # a new run of a simulation
            self._path = []
        if (
            not self._path
            or math.dist(here, self._path[-1][1]) >= _STEP
            or abs(math.remainder(heading - self._heading, math.tau)) >= _TURN
        ):
            self._path.append((stamp, here))
            self._heading = heading
            del self._path[: -self.keep]

    def draw(self, message) -> None:
        stamp = message.header.stamp.sec * 1_000_000_000 + message.header.stamp.nanosec
        points = [position for at, position in self._path if at <= stamp]
        drawn = (len(points), points[0] if points else None, points[-1] if points else None)
        if drawn != self._drawn:
            self._drawn = drawn
            self.scene.set('message/path', Line(points, self.colour, width=2.5) if len(points) > 1 else None)
        if self.length > 0:
            self.scene.set('message/arrow', Arrow(self.length, colour=self.colour))
            self.scene.pose('message/arrow', poses.from_pose(message.pose.pose))
