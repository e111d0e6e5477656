"""`too_slow`: data comes, but too seldom."""

import re

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict

_PUBLISHER = """\
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32


class Publisher(Node):
    def __init__(self):
        super().__init__('{node}')
        self.publisher = self.create_publisher(Int32, '{topic}', 10)
        self.create_timer({period}, self.on_timer)
        self.count = {first}
        self.get_logger().info('ready')

    def on_timer(self):
        begin = time.monotonic()
{wait}        self.count += 1
        self.publisher.publish(Int32(data=self.count))
        self.get_logger().debug(f'published after {{time.monotonic() - begin:.3f}} s')


rclpy.init()
try:
    rclpy.spin(Publisher())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""
_SUBSCRIBER = '''\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32


class Subscriber(Node):
    """Prints how many messages a second have been sent, from the times at which the publisher sent the last ones."""

    def __init__(self):
        super().__init__('{node}')
        self.create_subscription(Int32, '{topic}', self.on_message, 10)
        self.create_timer(0.5, self.on_timer)
        self.sent = []
        self.get_logger().info('ready')

    def on_message(self, message, info):
        self.sent = [*self.sent[-5:], info['source_timestamp'] / 1e9]

    def on_timer(self):
        if len(self.sent) > 1:
            rate = (len(self.sent) - 1) / (self.sent[-1] - self.sent[0])
            self.get_logger().info(f'{{rate:.1f}} messages a second')


rclpy.init()
try:
    rclpy.spin(Subscriber())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
'''
ENOUGH, TOO_MANY = 8.0, 14.0  # messages a second; with a timer of 0.1 s there are ten
_RATE = re.compile(r'(?<![\d.])([\d.]+) messages a second')


class TooSlow(Fault):
    """A publisher works, and publishes too seldom.

    Kinds: ``period`` (its timer has another period), ``busy`` (its callback waits for longer than the period).
    """

    name, title = 'too_slow', 'data comes, but too seldom'
    kinds = ('period', 'busy')

    def plan(self) -> None:
        draw = self.random
        topic, self.publisher, _ = draw.choice(words.SENSORS)
        self.listener = draw.choice(words.LISTENERS)
        seconds = draw.choice([0.4, 0.5, 0.8, 1.0])
        values = {'node': self.publisher, 'topic': topic, 'first': draw.randrange(10, 60), 'period': 0.1, 'wait': ''}
        wrong = {
            'period': {'period': seconds},
            'busy': {'wait': f'        time.sleep({seconds})  # the sensor needs a moment\n'},
        }
        where = f'{self.publisher}.py'
        self.files = {
            where: _PUBLISHER.format(**values | wrong[self.kind]),
            f'{self.listener}.py': _SUBSCRIBER.format(node=self.listener, topic=topic),
            START: f'python3 {self.publisher}.py\npython3 {self.listener}.py\n',
        }
        self.repaired = {where: _PUBLISHER.format(**values)}
        self.diagnose(where, 'rate', f'{1 / seconds:.1f}')
        self.facts = {'topic': f'/{topic}'}
        self.task = (
            f'{self.publisher}.py should publish ten times a second. {self.listener}.py prints how often it does.'
        )

    def rates(self) -> list[float]:
        """What the listener has printed: messages a second."""
        return [float(found[1]) for line in self.lines(self.listener) if (found := _RATE.search(line))]

    def works(self, timeout: float) -> Verdict:
        works = self.watch(lambda: any(ENOUGH < rate < TOO_MANY for rate in self.rates()[-3:]), timeout)
        told = f'{self.rates()[-1]:.0f} messages' if self.rates() else 'no messages'
        return Verdict(works, 'ten messages a second' if works else f'{told} a second, not ten')

    def show_symptom(self) -> None:
        self.watch(lambda: len(self.rates()) >= 3, self.patience)
        self.show_programs()
