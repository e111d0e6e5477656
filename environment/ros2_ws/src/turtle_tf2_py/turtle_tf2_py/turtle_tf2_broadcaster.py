"""``turtle_tf2_broadcaster``: the pose of the turtle ``turtlename`` becomes a frame in ``world``."""

from node_program.running import run
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose

from turtle_tf2_py.transforms import transform


class FramePublisher(Node):
    """Broadcasts a turtle's frame each time that its pose comes."""

    def __init__(self):
        super().__init__('turtle_tf2_frame_publisher')
        self.turtlename = self.declare_parameter('turtlename', 'turtle').value
        self.tf_broadcaster = TransformBroadcaster(self)
        self.subscription = self.create_subscription(Pose, f'/{self.turtlename}/pose', self.handle_turtle_pose, 1)

    def handle_turtle_pose(self, msg: Pose) -> None:
        """Broadcast the frame of this pose; turtlesim's poses have no stamp, so it is that of now."""
        now = self.get_clock().now().to_msg()
        self.tf_broadcaster.sendTransform(
            transform(now, 'world', self.turtlename, (msg.x, msg.y, 0.0), (0.0, 0.0, msg.theta))
        )


def main() -> None:
    """Run the program."""
    run(FramePublisher)
