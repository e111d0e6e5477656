"""``draw_square``: drive turtle1 along a square, for ever, looking at its pose."""

import math
from dataclasses import dataclass

from geometry_msgs.msg import Twist
from node_program.running import run
from std_srvs.srv import Empty
from turtlesim.msg import Pose

from turtlesim_nodes.node import TurtlesimNode
from turtlesim_nodes.qos import TOPIC_QOS
from turtlesim_nodes.world import STEP, normalize

SIDE = 2.0  # metres
STILL = 0.0001


@dataclass
class Goal:
    """Where the turtle shall be, and which way it shall look."""

    x: float
    y: float
    theta: float


class SquareDriver:
    """Decides the next velocity from a pose; knows nothing of ROS but the fields of the pose."""

    def __init__(self, log=lambda text: None):
        self._log = log
        self._state = self._forward
        self.goal: Goal | None = None

    def step(self, pose) -> tuple[float, float] | None:
        """Return (linear, angular) to command now, or None to command nothing this time."""
        if self.goal is None:
            self._aim_ahead(pose)
        return self._state(pose)

    def _forward(self, pose) -> tuple[float, float]:
        if not self._reached(pose):
            return 1.0, 0.0
        self._state = self._stop_forward
        return 0.0, 0.0

    def _stop_forward(self, pose) -> tuple[float, float] | None:
        if not self._still(pose):
            return 0.0, 0.0
        self._log('Reached goal')
        self._state = self._turn
        self._aim(Goal(pose.x, pose.y, normalize(pose.theta + math.pi / 2)))
        return None

    def _turn(self, pose) -> tuple[float, float]:
        if not self._reached(pose):
            return 0.0, 0.4
        self._state = self._stop_turn
        return 0.0, 0.0

    def _stop_turn(self, pose) -> tuple[float, float] | None:
        if not self._still(pose):
            return 0.0, 0.0
        self._log('Reached goal')
        self._state = self._forward
        self._aim_ahead(pose)
        return None

    def _aim_ahead(self, pose) -> None:
        x = pose.x + SIDE * math.cos(pose.theta)
        self._aim(Goal(x, pose.y + SIDE * math.sin(pose.theta), pose.theta))

    def _aim(self, goal: Goal) -> None:
        self.goal = goal
        self._log(f'New goal [{goal.x:f} {goal.y:f}, {goal.theta:f}]')

    def _reached(self, pose) -> bool:
        near = abs(pose.x - self.goal.x) < 0.1 and abs(pose.y - self.goal.y) < 0.1
        # The difference is normalized: stock compares plainly and can miss a goal at the seam of -pi and pi.
        return near and abs(normalize(pose.theta - self.goal.theta)) < 0.01

    @staticmethod
    def _still(pose) -> bool:
        return pose.angular_velocity < STILL and pose.linear_velocity < STILL


class DrawSquare(TurtlesimNode):
    """The node ``draw_square``: resets the simulator, then drives."""

    def __init__(self):
        super().__init__('draw_square')
        self._driver = SquareDriver(lambda text: self.get_logger().info(text))
        self._pose: Pose | None = None
        self._twist = self.create_publisher(Twist, 'turtle1/cmd_vel', TOPIC_QOS)
        self.create_subscription(Pose, 'turtle1/pose', self._on_pose, TOPIC_QOS)
        self.create_timer(STEP, self._on_timer)
        self._reset_client = self.create_client(Empty, 'reset')
        self._reset = None

    def _is_reset(self) -> bool:
        """Reset the simulator as soon as it is there; poses count only from then on."""
        if self._reset is None and self._reset_client.service_is_ready():
            self._reset = self._reset_client.call_async(Empty.Request())
        return self._reset is not None and self._reset.done()

    def _on_pose(self, pose: Pose) -> None:
        if self._is_reset():
            self._pose = pose

    def _on_timer(self) -> None:
        if not self._is_reset() or self._pose is None:
            return
        command = self._driver.step(self._pose)
        if command is not None:
            twist = Twist()
            twist.linear.x, twist.angular.z = command
            self._twist.publish(twist)


def main(args=None) -> None:
    """Drive until Ctrl+C."""
    run(DrawSquare, args)
