"""``turtle_tf2_message_broadcaster``: ``turtle3`` drives in circles and tells its place as a point in ``world``."""

from geometry_msgs.msg import PointStamped, Twist
from node_program.running import run
from rclpy.node import Node
from turtlesim.msg import Pose

from turtle_tf2_py.spawning import SpawnedTurtle

TURTLE = 'turtle3'


class PointPublisher(Node):
    """Spawns the turtle; each of its poses becomes a stamped point, and is answered with a command."""

    def __init__(self):
        super().__init__('turtle_tf2_message_broadcaster')
        self.turtle = SpawnedTurtle(self, TURTLE)
        self.timer = self.create_timer(1.0, self.on_timer)

    def on_timer(self) -> None:
        """Make the publishers and the subscription when the turtle is there."""
        if self.turtle.is_there():
            self.timer.cancel()
            self.vel_pub = self.create_publisher(Twist, f'{TURTLE}/cmd_vel', 10)
            self.pub = self.create_publisher(PointStamped, f'{TURTLE}/turtle_point_stamped', 10)
            self.sub = self.create_subscription(Pose, f'{TURTLE}/pose', self.handle_turtle_pose, 10)

    def handle_turtle_pose(self, msg: Pose) -> None:
        """Drive on, and publish where the turtle is."""
        command = Twist()
        command.linear.x = command.angular.z = 1.0
        self.vel_pub.publish(command)
        point = PointStamped()
        point.header.stamp = self.get_clock().now().to_msg()
        point.header.frame_id = 'world'
        point.point.x, point.point.y = msg.x, msg.y
        self.pub.publish(point)


def main() -> None:
    """Run the program."""
    run(PointPublisher)
