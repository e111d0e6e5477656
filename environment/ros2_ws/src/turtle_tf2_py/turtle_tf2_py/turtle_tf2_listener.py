"""``turtle_tf2_listener``: ``turtle2`` follows the frame ``target_frame``."""

import math

from geometry_msgs.msg import Twist
from node_program.running import run
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

from turtle_tf2_py.spawning import SpawnedTurtle

FOLLOWER = 'turtle2'
TURN_RATE, SPEED = 1.0, 0.5  # rad/s for each radian, m/s for each metre


class FrameListener(Node):
    """Spawns the follower, and drives it once a second towards where the target is now."""

    def __init__(self):
        super().__init__('turtle_tf2_frame_listener')
        self.target_frame = self.declare_parameter('target_frame', 'turtle1').value
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.turtle = SpawnedTurtle(self, FOLLOWER)
        self.publisher = self.create_publisher(Twist, f'{FOLLOWER}/cmd_vel', 1)
        self.timer = self.create_timer(1.0, self.on_timer)

    def on_timer(self) -> None:
        """Drive, if the follower is there and both frames are known."""
        if not self.turtle.is_there():
            return
        try:
            place = self.tf_buffer.lookup_transform(FOLLOWER, self.target_frame, Time()).transform.translation
        except TransformException as error:
            self.get_logger().info(f'Could not transform {FOLLOWER} to {self.target_frame}: {error}')
            return
        command = Twist()
        command.angular.z = TURN_RATE * math.atan2(place.y, place.x)
        command.linear.x = SPEED * math.hypot(place.x, place.y)
        self.publisher.publish(command)


def main() -> None:
    """Run the program."""
    run(FrameListener)
