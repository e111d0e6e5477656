"""`no_transform`: tf2 cannot look a transform up, or gives the wrong one."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict

DRIVER = '''\
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from tf2_ros import TransformBroadcaster


class Driver(Node):
    """The robot drives ahead, along x, with 0.5 m/s."""

    def __init__(self):
        super().__init__('{node}')
        self.broadcaster = TransformBroadcaster(self)
        self.x = 1.0
        self.create_timer(0.1, self.on_timer)
        self.get_logger().info('ready')

    def on_timer(self):
        self.x += 0.05
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = '{parent}'
        transform.child_frame_id = '{child}'
        transform.transform.translation.x = self.x
        transform.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(transform)


rclpy.init()
try:
    rclpy.spin(Driver())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
'''
LOOKER = '''\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class Looker(Node):
    """Where is the {sensor}, seen from odom?"""

    def __init__(self):
        super().__init__('{node}')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(0.3, self.on_timer)

    def on_timer(self):
        try:
            found = self.buffer.lookup_transform('odom', '{sensor}', Time())
        except TransformException as error:
            self.get_logger().warning(f'{{error}}')
        else:
            self.get_logger().info(f'x = {{found.transform.translation.x:.2f}} m')


rclpy.init()
try:
    rclpy.spin(Looker())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
'''


class NoTransform(Fault):
    """A program does not learn where a sensor of the robot is.

    Kinds: ``no_broadcaster`` (nobody publishes the sensor's place), ``swapped`` (parent and child of a moving frame
    changed places), ``child`` (the sensor's frame is misspelt), ``parent`` (two trees that are not connected).
    """

    name, title = 'no_transform', 'tf2 does not know where a frame is'
    kinds = ('no_broadcaster', 'swapped', 'child', 'parent')

    def plan(self) -> None:
        draw = self.random
        sensor, driver = draw.choice(words.SENSOR_FRAMES), draw.choice(['base', 'wheels', 'drive'])
        self.looker = draw.choice(['where', 'finder', 'locator'])
        self.ahead = draw.randrange(2, 9) / 10
        wrong_sensor, wrong_base = words.misspelt(sensor, draw), draw.choice(['base', 'baselink', 'base_lnik'])

        def mount(parent: str, child: str) -> str:
            return (
                f'ros2 run tf2_ros static_transform_publisher --x {self.ahead} --frame-id {parent} '
                f'--child-frame-id {child}\n'
            )

        sound = {
            START: f'python3 {driver}.py\n{mount("base_link", sensor)}python3 {self.looker}.py\n',
            f'{driver}.py': DRIVER.format(node=driver, parent='odom', child='base_link'),
            f'{self.looker}.py': LOOKER.format(node=self.looker, sensor=sensor),
        }
        self.files, where = dict(sound), START
        if self.kind == 'swapped':
            where = f'{driver}.py'
            self.files[where] = DRIVER.format(node=driver, parent='base_link', child='odom')
        else:
            broken = {
                'no_broadcaster': f'# {mount("base_link", sensor)}',
                'child': mount('base_link', wrong_sensor),
                'parent': mount(wrong_base, sensor),
            }[self.kind]
            self.files[START] = sound[START].replace(mount('base_link', sensor), broken)
        self.repaired = {where: sound[where]}
        self.task = (
            f'The robot drives ahead from x = 1 m. {self.looker}.py should print how far its {sensor} is, '
            'seen from odom: x grows.'
        )
        cause, evidence = {
            'no_broadcaster': ('unknown', ''),
            'swapped': ('exchanged', 'base_link'),
            'child': ('unknown', wrong_sensor),
            'parent': ('not connected', wrong_base),
        }[self.kind]
        self.diagnose(where, cause, evidence)
        self.facts = {'chain': ('odom', 'base_link', sensor)}

    def start(self) -> list[str]:
        """Start what has changed, and then the program that looks: it would remember the old frames."""
        started = super().start()
        if started and self.looker in self.programs and self.looker not in started:
            self.programs.pop(self.looker).stop()
            started += super().start()
        return started

    def show_symptom(self) -> None:
        before = len(self.lines(self.looker))
        self.watch(lambda: len(self.lines(self.looker)) >= before + 4, self.patience)
        self.show_programs()

    def works(self, timeout: float) -> Verdict:
        def grows() -> bool:
            found = [float(line.split()[-2]) for line in self.lines(self.looker) if 'x = ' in line]
            return len(found) >= 2 and found[-1] > found[-2] > 1.0 + self.ahead

        good = self.watch(grows, timeout)
        return Verdict(good, f'{self.looker} {"prints" if good else "does not print"} an x that grows')
