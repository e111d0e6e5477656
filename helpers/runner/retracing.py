"""Where the commands on /cmd_vel bring a robot: they are heard here, and drive a simulated world of the tests' own.

A launched system may tell of a robot that stands, or of a world in which nothing stops it. What it says of the robot's
way counts only as far as its commands lead there, in the time that has gone by here.

    way = Way(node, factor)        # hears cmd_vel and odom
    …
    way.odometer, way.retraced()   # metres along x: what the world says, and where the commands lead
"""

import math
import time

from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.node import Node

QUEUE = 200
AHEAD = 2.0  # simulated seconds that the system's clock may be ahead of ours
TIMEOUT = 0.5  # simulated seconds after which a robot stops without a command, as the node's parameter says


class Way:
    """What a node of the test's hears of a robot's way, in the scene `empty`.

    :param factor: simulated seconds in a second, at most.
    """

    def __init__(self, node: Node, factor: float):
        self.odometry = Odometry()  # the last that the world has said
        self._factor = factor
        self._begin: tuple[float, float] | None = None  # simulated seconds, and ours
        self._now = 0.0  # simulated seconds since the first message
        self._commands: list[tuple[float, Twist]] = []
        self.speakers = {'cmd_vel': 0, 'odom': 0}  # publishers that were ever there
        node.create_subscription(
            Twist,
            'cmd_vel',
            lambda command: self._commands.append((self._now, command)),
            QUEUE,
            event_callbacks=self._counting('cmd_vel'),
        )
        node.create_subscription(Odometry, 'odom', self._on_odometry, QUEUE, event_callbacks=self._counting('odom'))

    def _counting(self, topic: str) -> SubscriptionEventCallbacks:
        def matched(event) -> None:
            self.speakers[topic] = event.total_count

        return SubscriptionEventCallbacks(matched=matched)

    @property
    def odometer(self) -> float:
        """Metres along x, as the world says."""
        return self.odometry.pose.pose.position.x

    def _on_odometry(self, odometry: Odometry) -> None:
        self.odometry = odometry
        stamp = odometry.header.stamp.sec + odometry.header.stamp.nanosec / 1e9
        ours = time.monotonic()
        if self._begin is None:
            self._begin = stamp, ours
        # Time that runs faster than it was asked to makes no way longer.
        latest = (ours - self._begin[1]) * self._factor + AHEAD
        self._now = max(self._now, min(stamp - self._begin[0], latest))

    def retraced(self) -> float:
        """Metres along x to which the commands lead that were heard until now."""
        from mujoco_world.world import CONTROL_PERIOD, World  # imports the physics, which few tests need

        world = World(scene='empty', command_timeout=TIMEOUT)
        left = [
            (at, command)
            for at, command in self._commands
            if math.isfinite(command.linear.x) and math.isfinite(command.angular.z)
        ]
        for tick in range(math.floor(self._now / CONTROL_PERIOD)):
            while left and left[0][0] <= tick * CONTROL_PERIOD:
                command = left.pop(0)[1]
                world.drive(command.linear.x, command.angular.z)
            world.step()
        return world.pose.x
