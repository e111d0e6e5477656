"""``fixed_frame_tf2_broadcaster``: the frame ``carrot1``, two metres to the left of ``turtle1``."""

from node_program.running import run
from rclpy.node import Node
from tf2_ros import TransformBroadcaster

from turtle_tf2_py.transforms import transform


class FixedFrameBroadcaster(Node):
    """Broadcasts the same place ten times a second."""

    def __init__(self):
        super().__init__('fixed_frame_tf2_broadcaster')
        self.tf_broadcaster = TransformBroadcaster(self)
        self.timer = self.create_timer(0.1, self.broadcast_timer_callback)

    def broadcast_timer_callback(self) -> None:
        """Broadcast the place, with the stamp of now."""
        now = self.get_clock().now().to_msg()
        self.tf_broadcaster.sendTransform(transform(now, 'turtle1', 'carrot1', (0.0, 2.0, 0.0)))


def main() -> None:
    """Run the program."""
    run(FixedFrameBroadcaster)
