"""``dynamic_frame_tf2_broadcaster``: the frame ``carrot1``, which jumps from one side of ``turtle1`` to the other."""

import math

from node_program.running import run
from rclpy.node import Node
from tf2_ros import TransformBroadcaster

from turtle_tf2_py.transforms import transform

RADIUS = 10.0  # metres


class DynamicFrameBroadcaster(Node):
    """Broadcasts a place that depends on the whole second of now, ten times a second."""

    def __init__(self):
        super().__init__('dynamic_frame_tf2_broadcaster')
        self.tf_broadcaster = TransformBroadcaster(self)
        self.timer = self.create_timer(0.1, self.broadcast_timer_callback)

    def broadcast_timer_callback(self) -> None:
        """Broadcast the place of this second: half a turn each second."""
        now = self.get_clock().now()
        angle = now.seconds_nanoseconds()[0] * math.pi
        place = (RADIUS * math.sin(angle), RADIUS * math.cos(angle), 0.0)
        self.tf_broadcaster.sendTransform(transform(now.to_msg(), 'turtle1', 'carrot1', place))


def main() -> None:
    """Run the program."""
    run(DynamicFrameBroadcaster)
