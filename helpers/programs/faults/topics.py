"""`no_data`: publisher and subscriber are up, and no data comes."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict

PUBLISHER = """\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import {type}


class Publisher(Node):
    def __init__(self):
        super().__init__('{node}')
        qos = QoSProfile(
            depth=5,
            reliability=ReliabilityPolicy.{reliability},
            durability=DurabilityPolicy.{durability})
        self.publisher = self.create_publisher({type}, '{topic}', qos)
        self.create_timer(0.1, self.on_timer)
        self.count = {first}

    def on_timer(self):
        self.count += 1
        self.publisher.publish({type}(data={value}))
        if self.count % 5 == 0:
            self.get_logger().info(f'published {{self.count}} {unit}')


rclpy.init()
try:
    rclpy.spin(Publisher())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""
SUBSCRIBER = """\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import {type}


class Subscriber(Node):
    def __init__(self):
        super().__init__('{node}')
        qos = QoSProfile(
            depth=5,
            reliability=ReliabilityPolicy.{reliability},
            durability=DurabilityPolicy.{durability})
        self.create_subscription({type}, '{topic}', self.on_message, qos)
        self.get_logger().info('ready')

    def on_message(self, message):
        self.get_logger().info(f'heard {{message.data}} {unit}')


rclpy.init()
try:
    rclpy.spin(Subscriber())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""


class NoData(Fault):
    """The publisher publishes, the subscriber hears nothing.

    Kinds: ``reliability`` and ``durability`` (QoS that does not fit), ``name`` (misspelt topic), ``namespace`` (one
    side is in a namespace, the other is not), ``type``.
    """

    name, title = 'no_data', 'both programs run, but no data arrives'
    kinds = ('reliability', 'durability', 'name', 'namespace', 'type')

    def plan(self) -> None:
        draw = self.random
        topic, publisher, unit = draw.choice(words.SENSORS)
        room, listener = draw.choice(words.ROOMS), draw.choice(words.LISTENERS)
        wrong = words.misspelt(topic, draw)
        number, other = draw.sample([('Int32', 'self.count'), ('Float32', 'float(self.count)')], 2)
        sides = {
            side: {
                'node': node,
                'topic': f'{room}/{topic}',
                'unit': unit,
                'type': number[0],
                'value': number[1],
                'reliability': 'RELIABLE',
                'durability': 'VOLATILE',
                'first': draw.randrange(10, 60),
            }
            for side, node in (('publisher', publisher), ('subscriber', listener))
        }
        sound = {
            f'{publisher}.py': PUBLISHER.format(**sides['publisher']),
            f'{listener}.py': SUBSCRIBER.format(**sides['subscriber']),
        }
        start = f'python3 {publisher}.py\npython3 {listener}.py\n'
        sound[START] = start
        topics, where = [f'/{room}/{topic}'] * 2, f'{listener}.py'
        if self.kind == 'reliability':
            sides['publisher']['reliability'] = 'BEST_EFFORT'
            where = f'{publisher}.py'
        elif self.kind == 'durability':
            sides['subscriber']['durability'] = 'TRANSIENT_LOCAL'
        elif self.kind == 'name':
            sides['subscriber']['topic'] = f'{room}/{wrong}'
            topics[1] = f'/{room}/{wrong}'
        elif self.kind == 'type':
            sides['subscriber']['type'] = other[0]
        self.files = {
            f'{publisher}.py': PUBLISHER.format(**sides['publisher']),
            f'{listener}.py': SUBSCRIBER.format(**sides['subscriber']),
            START: start,
        }
        if self.kind == 'namespace':
            robot, where = draw.choice(words.ROBOTS), START
            self.files[START] = start.replace(f'{publisher}.py', f'{publisher}.py --ros-args -r __ns:=/{robot}')
            topics[0] = f'/{robot}/{room}/{topic}'
        self.repaired = {where: sound[where]}
        self.publisher, self.listener = publisher, listener
        self.task = (
            f'{publisher}.py measures and publishes ten times a second. {listener}.py should print what it hears.'
        )
        offered, requested = (sides[side].get(self.kind, '') for side in ('publisher', 'subscriber'))
        evidence = {'name': topics[0], 'namespace': topics[0], 'type': f'std_msgs/msg/{offered}'}
        self.diagnose(where, 'name' if self.kind == 'namespace' else self.kind, evidence.get(self.kind, offered))
        self.facts = {
            'publisher_topic': topics[0],
            'subscriber_topic': topics[1],
            'offered': offered,
            'requested': requested,
        }

    def works(self, timeout: float) -> Verdict:
        heard = self.watch(lambda: any('heard' in line for line in self.lines(self.listener)), timeout)
        does = 'prints' if heard else 'does not print'
        return Verdict(heard, f'{self.listener} {does} what {self.publisher} measures')

    def show_symptom(self) -> None:
        both = self.watch(lambda: len(self.lines(self.publisher)) >= 2 and self.lines(self.listener), self.patience)
        if not both:
            print('(a program has not come up)')
        self.show_programs()
