"""Cases for `test_runner`: programs that drive the simulated robot."""

from helpers.tests.small import Case

HEAD = """
import time
from helpers.runner.mobile_robot import MobileRobot
"""
DRIVER = """\
from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformException, TransformListener
from rclpy.time import Time

class Talker(Node):
    def __init__(self):
        super().__init__('driver')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.publisher = self.create_publisher(Twist, '/cmd_vel', 10)
        self.create_subscription(LaserScan, '/scan', self.on_scan, 10)

    def on_scan(self, scan):
        try:
            laser = self.buffer.lookup_transform('map', 'laser', Time())
        except TransformException:
            return
        twist = Twist()
        if scan.ranges[180] > 1.0 and laser.transform.translation.x < 2.0:
            twist.linear.x = 0.4
        self.publisher.publish(twist)
"""
DRIVE = (
    HEAD
    + """
robot = MobileRobot(learner)
learner.start('Talker')
learner.run(8.0, until=lambda: robot.distance(2.0, 0.0) < 0.3 and not robot.moving())
"""
)
CASES = {
    'a program drives the robot by what the robot sees': Case(
        DRIVER,
        DRIVE
        + """
expect(abs(robot.pose.x - 1.95) < 0.1 and abs(robot.pose.y) < 0.01, f'{robot.pose}')
expect(not robot.bumps and robot.path[-1][0] < 7.0, f'{robot.bumps} {robot.path[-1]}')
""",
    ),
    'a wall stops the robot, and is named': Case(
        DRIVER.replace('> 1.0', '> 0.0').replace('< 2.0', '< 9.0'),
        HEAD
        + """
robot = MobileRobot(learner, start=(3.0, 0.0, 0.0))
learner.start('Talker')
learner.run(4.0)
expect(robot.bumps == ['east'] and 3.8 < robot.pose.x < 3.9, f'{robot.bumps} {robot.pose}')
""",
    ),
    'the localiser falls silent and speaks again': Case(
        DRIVER,
        HEAD
        + """
robot = MobileRobot(learner, 'empty')
tf = learner.tf_listener()
learner.start('Talker')
learner.run(0.25)
robot.localization = False
learner.run(1.0)
def drifts():
    return sum(one.child_frame_id == 'odom' for message in tf.moving.messages for one in message.transforms)
heard = drifts()
robot.localization = True
learner.run(0.25)
expect(1 <= heard <= 4 and drifts() > heard, f'{heard} {drifts()}')
""",
    ),
    'without commands the robot stops': Case(
        """\
from geometry_msgs.msg import Twist

class Talker(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/cmd_vel', 10)
        self.timer = self.create_timer(0.2, self.once)

    def once(self):
        self.timer.cancel()
        twist = Twist()
        twist.linear.x = 0.4
        self.publisher.publish(twist)
""",
        HEAD
        + """
robot = MobileRobot(learner, 'empty')
learner.start('Talker')
learner.run(0.65)
expect(robot.moving(0.3), f'{robot.pose}')
learner.run(1.0)
expect(not robot.moving() and robot.commands.stamps == [0.2], f'{robot.pose} {robot.commands.stamps}')
""",
    ),
    'the robot is driven on the wrong topic': Case(
        DRIVER.replace('/cmd_vel', '/robot/cmd_vel'),
        DRIVE
        + """
expect(len(robot.commands), 'The robot got no command.')
""",
        'failed',
        messages=('The robot got no command.', 'no publisher on /cmd_vel; it has one on /robot/cmd_vel'),
    ),
}
