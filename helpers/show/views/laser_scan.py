"""The display of a laser scan."""

import numpy as np

from helpers.show.views.shapes import RED, Points
from helpers.show.views.topic_display import StampedDisplay


class LaserScan(StampedDisplay):
    """The points that a laser scanner sees (sensor_msgs/LaserScan).

    Measurements below ``range_min`` or above ``range_max``, and those that are no number, are left out.

    :param topic: name of the topic.
    :param colour: red, green, blue from 0 to 1.
    :param size: of a point in m.
    :param qos: QoS or depth; None: as in RViz, reliable. A scanner that publishes best effort needs
        ``qos_profile_sensor_data``; the status says so.
    """

    def __init__(self, topic: str = '/scan', colour=RED, size: float = 0.06, qos=None):
        super().__init__(topic, qos)
        self.colour, self.size = colour, size
        self._beams: tuple = ()
        self._directions = np.empty((0, 2))

    def message_type(self):
        from sensor_msgs.msg import LaserScan

        return LaserScan

    def draw(self, message) -> None:
        self.scene.set('message', Points(self.points(message), self.colour, self.size))

    def points(self, message) -> np.ndarray:
        """Return the points of a scan in its own frame, N x 3 in m."""
        ranges = np.asarray(message.ranges, dtype=np.float32)
        beams = (len(ranges), message.angle_min, message.angle_increment)
        if beams != self._beams:  # the same for all messages of a scanner
            angles = message.angle_min + message.angle_increment * np.arange(len(ranges))
            self._beams, self._directions = beams, np.column_stack((np.cos(angles), np.sin(angles)))
        # NaN and infinity fail the comparisons; a range_max of 0 or infinity is no limit.
        limit = message.range_max if message.range_max > 0 else np.inf
        seen = (ranges >= message.range_min) & (ranges <= limit) & np.isfinite(ranges)
        points = np.zeros((int(seen.sum()), 3), dtype=np.float32)
        points[:, :2] = self._directions[seen] * ranges[seen, None]
        return points
