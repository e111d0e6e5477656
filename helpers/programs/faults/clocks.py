"""`wrong_time`: two programs do not have the same time."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict

_PUBLISHER = """\
import rclpy
from geometry_msgs.msg import PointStamped
from rclpy.clock import Clock, ClockType
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Publisher(Node):
    def __init__(self):
        super().__init__('{node}')
        self.publisher = self.create_publisher(PointStamped, '{topic}', 10)
        self.clock = {clock}
        self.create_timer(0.1, self.on_timer)
        self.count = {first}
        self.get_logger().info('ready')

    def on_timer(self):
        self.count += 1
        message = PointStamped()
        message.header.stamp = self.clock.now().to_msg()
        message.point.x = float(self.count)
        self.publisher.publish(message)
        if self.count % 5 == 0:
            self.get_logger().info(f'published {{self.count}} {unit}')


rclpy.init()
try:
    rclpy.spin(Publisher())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""
_SUBSCRIBER = '''\
import rclpy
from geometry_msgs.msg import PointStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time


class Subscriber(Node):
    """Prints what is new; what is older than three seconds, or comes from the future, is thrown away."""

    def __init__(self):
        super().__init__('{node}')
        self.create_subscription(PointStamped, '{topic}', self.on_message, 10)
        self.get_logger().info('ready')

    def on_message(self, message):
        stamp = Time.from_msg(message.header.stamp, clock_type=self.get_clock().clock_type)
        age = (self.get_clock().now() - stamp).nanoseconds / 1e9
        if -3 < age < 3:
            self.get_logger().info(f'heard {{message.point.x:.0f}} {unit}')
        else:
            self.get_logger().warning(f'thrown away: {{age:.0f}} s old', throttle_duration_sec=0.5)


rclpy.init()
try:
    rclpy.spin(Subscriber())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
'''
_OWN, _STEADY = 'self.get_clock()', 'Clock(clock_type=ClockType.STEADY_TIME)'
SIM_TIME = ' --ros-args -p use_sim_time:=true'


class WrongTime(Fault):
    """A program waits for a time that does not come, or takes every message for too old.

    Kinds: ``no_clock`` (a node has ``use_sim_time``, and nobody publishes ``/clock``), ``other_clock`` (stamps
    are those of a clock that begins with the start of the machine).
    """

    name, title = 'wrong_time', 'timers never fire, or every message is too old'
    kinds = ('no_clock', 'other_clock')

    def plan(self) -> None:
        draw = self.random
        topic, self.publisher, unit = draw.choice(words.SENSORS)
        self.listener = draw.choice(words.LISTENERS)
        asleep, first = draw.choice([self.publisher, self.listener]), draw.randrange(10, 60)
        files = {
            f'{self.publisher}.py': _PUBLISHER.format(
                node=self.publisher, topic=topic, unit=unit, first=first, clock=_OWN
            ),
            f'{self.listener}.py': _SUBSCRIBER.format(node=self.listener, topic=topic, unit=unit),
            START: f'python3 {self.publisher}.py\npython3 {self.listener}.py\n',
        }
        if self.kind == 'no_clock':
            where, wrong = START, files[START].replace(f'{asleep}.py', f'{asleep}.py{SIM_TIME}')
            self.diagnose(where, 'no clock', f'python3 {asleep}.py{SIM_TIME}')
        else:
            where = f'{self.publisher}.py'
            wrong = files[where].replace(f'self.clock = {_OWN}', f'self.clock = {_STEADY}')
            self.diagnose(where, 'other clock', f'self.clock = {_STEADY}')
        self.files, self.repaired = {**files, where: wrong}, {where: files[where]}
        self.facts = {'asleep': asleep, 'topic': f'/{topic}'}
        self.task = (
            f'{self.publisher}.py measures ten times a second, and writes the time into each message. '
            f'{self.listener}.py should print what is not older than three seconds.'
        )

    def works(self, timeout: float) -> Verdict:
        heard = self.watch(lambda: any('heard' in line for line in self.lines(self.listener)), timeout)
        does = 'prints' if heard else 'does not print'
        return Verdict(heard, f'{self.listener} {does} what {self.publisher} measures')

    def show_symptom(self) -> None:
        both = self.watch(lambda: self.lines(self.publisher) and self.lines(self.listener), self.patience)
        if not both:
            print('(a program has not come up)')
        self.watch(lambda: len(self.lines(self.publisher)) + len(self.lines(self.listener)) >= 5, 2.0)
        self.show_programs()
