"""``mimic``: let one turtle do what another does. Remap input/pose and output/cmd_vel to the two."""

from geometry_msgs.msg import Twist
from node_program.running import run
from turtlesim.msg import Pose

from turtlesim_nodes.node import TurtlesimNode
from turtlesim_nodes.qos import TOPIC_QOS


class Mimic(TurtlesimNode):
    """The node ``turtle_mimic``: the pose of one turtle becomes the velocity of another."""

    def __init__(self):
        super().__init__('turtle_mimic')
        self._twist = self.create_publisher(Twist, 'output/cmd_vel', TOPIC_QOS)
        self.create_subscription(Pose, 'input/pose', self._on_pose, TOPIC_QOS)

    def _on_pose(self, pose: Pose) -> None:
        twist = Twist()
        twist.linear.x = pose.linear_velocity
        twist.angular.z = pose.angular_velocity
        self._twist.publish(twist)


def main(args=None) -> None:
    """Follow until Ctrl+C."""
    run(Mimic, args)
