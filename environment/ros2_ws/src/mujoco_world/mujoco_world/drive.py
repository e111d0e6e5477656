"""A differential drive's controller: from a velocity to wheel speeds, and from the wheels' turning to odometry."""

from dataclasses import dataclass
from math import cos, inf, sin

from mujoco_world.robot import Drive


@dataclass
class Odometry:
    """Where the robot believes to be, in the frame odom (metres, radians), and its velocity (m/s, rad/s)."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    linear: float = 0.0
    angular: float = 0.0

    def move(self, distance: float, angle: float) -> None:
        """Go on by a part of a circle: `distance` along it, while the direction changes by `angle`."""
        if abs(angle) < 1e-9:
            across, along = 0.0, distance
        else:
            along, across = distance / angle * sin(angle), distance / angle * (1 - cos(angle))
        self.x += along * cos(self.yaw) - across * sin(self.yaw)
        self.y += along * sin(self.yaw) + across * cos(self.yaw)
        self.yaw += angle


class Controller:
    """Follows a commanded velocity within the drive's limits of velocity and acceleration."""

    def __init__(self, drive: Drive):
        self.drive = drive
        self.target = (0.0, 0.0)  # m/s, rad/s
        self._now = (0.0, 0.0)

    def step(self, seconds: float) -> tuple[float, float]:
        """Return the speeds of the left and the right wheel, in rad/s, `seconds` later."""
        limits = (self.drive.linear_acceleration, self.drive.angular_acceleration)
        ranges = (self.drive.linear_velocity, self.drive.angular_velocity)
        targets = [max(least, min(most, target)) for target, (least, most) in zip(self.target, ranges, strict=True)]
        self._now = tuple(
            now + max(-limit * seconds, min(limit * seconds, target - now)) if limit < inf else target
            for now, target, limit in zip(self._now, targets, limits, strict=True)
        )
        linear, angular = self._now
        half = angular * self.drive.separation / 2
        return (linear - half) / self.drive.radius, (linear + half) / self.drive.radius

    def reset(self) -> None:
        """Stand still at once."""
        self.target = self._now = (0.0, 0.0)

    def motion(self, left: float, right: float) -> tuple[float, float]:
        """Return distance (m) and angle (rad) that the wheels' turning (rad) means, if they do not slip."""
        return ((left + right) * self.drive.radius / 2, (right - left) * self.drive.radius / self.drive.separation)
