"""Two faults of different rows in one system: one may hide the other."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict
from helpers.programs.faults.hang import waits_in_call
from helpers.programs.faults.machine import BASHRC, SETUP

_SHELL = """\
{source}
export ROS_DOMAIN_ID={domain}
export ROS_AUTOMATIC_DISCOVERY_RANGE={range}
"""
_ROBOT = """\
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import {type}
from {package}.srv import Trigger
from tf2_ros import TransformBroadcaster


class Robot(Node):
    def __init__(self):
        super().__init__('{robot}')
        qos = QoSProfile(depth=5, reliability=ReliabilityPolicy.{reliability})
        self.publisher = self.create_publisher({type}, '{topic}', qos)
        self.create_service(Trigger, '{service}', self.on_request)
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.1, self.on_timer)
        self.count = 10
        self.get_logger().info('ready')

    def on_timer(self):
        self.count += 1
        self.publisher.publish({type}(data={value}))
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = '{parent}'
        transform.child_frame_id = '{child}'
        transform.transform.translation.x = self.count / 10  # metres: it drives ahead
        transform.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(transform)

    def on_request(self, request, response):
        response.success, response.message = True, 'done'
        return response


rclpy.init()
try:
    rclpy.spin(Robot())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""
_PANEL = '''\
import faulthandler
import signal

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from std_msgs.msg import {type}
from {package}.srv import Trigger
from tf2_ros import Buffer, TransformException, TransformListener

faulthandler.register(signal.SIGUSR1)  # kill -USR1 PID: print where each thread stands


class Panel(Node):
    """Three things on one line; what is not known is a dash."""

    def __init__(self):
        super().__init__('panel')
        qos = QoSProfile(depth=5, reliability=ReliabilityPolicy.{reliability})
        self.create_subscription({type}, '{topic}', self.on_message, qos)
        self.client = self.create_client(Trigger, '{service}')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.value = self.answer = '-'
        self.create_timer(0.3, self.on_timer)
        self.get_logger().info('ready')

    def on_message(self, message):
        self.value = f'{{message.data}}'

    def on_answer(self, future):
        self.answer = future.result().message

    def on_timer(self):
        if self.client.service_is_ready():
{ask}
        try:
            found = self.buffer.lookup_transform('odom', 'base_link', Time())
            place = f'{{found.transform.translation.x:.1f}} m'
        except TransformException:
            place = '-'
        self.get_logger().info(f'{topic}: {{self.value}}, {service}: {{self.answer}}, base_link: {{place}}')


rclpy.init()
try:
    rclpy.spin(Panel())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
'''
_ASK = '            self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)'
_BLOCK = '            self.answer = self.client.call(Trigger.Request()).message'


class Mystery(Fault):
    """A robot and a panel on two machines, with two faults at once.

    ``diagnosis`` is ``{'faults': [two dictionaries with row, cause and where]}``; ``kind`` is always ``two``.
    """

    row, name, title = 'mystery', 'mystery', 'the panel does not show what it should'
    kinds = ('two',)
    program = 'panel'

    def plan(self) -> None:
        draw = self.random
        robot, (topic, _, _), (service, _, _) = (
            draw.choice(words.ROBOTS),
            draw.choice(words.SENSORS),
            draw.choice(words.SERVICES),
        )
        numbers = draw.sample([('Int32', 'self.count'), ('Float32', 'float(self.count)')], 2)
        packages = draw.sample(['std_srvs', 'example_interfaces'], 2)
        values = {
            'topic': topic,
            'type': numbers[0][0],
            'value': numbers[0][1],
            'reliability': 'RELIABLE',
            'service': service,
            'package': packages[0],
            'robot': robot,
            'parent': 'odom',
            'child': 'base_link',
            'ask': _ASK,
            'source': f'source ~/{SETUP.format(distro="jazzy")}',
            'domain': '@DOMAIN@',
            'range': 'LOCALHOST',
        }
        texts = {
            f'robot/{BASHRC}': _SHELL,
            f'panel/{BASHRC}': _SHELL,
            'robot/robot.py': _ROBOT,
            'panel/panel.py': _PANEL,
        }
        shell = draw.choice([f'robot/{BASHRC}', f'panel/{BASHRC}'])
        # row -> what may be wrong there: (cause, file, what is different in it)
        possible = {
            'A7.2': [
                ('unsourced', f'panel/{BASHRC}', {'source': '# (source ROS here)'}),
                ('wrong_file', f'panel/{BASHRC}', {'source': values['source'].replace('jazzy', 'humble')}),
            ],
            'A7.6': [
                ('name', 'panel/panel.py', {'topic': words.misspelt(topic, draw)}),
                ('reliability', 'robot/robot.py', {'reliability': 'BEST_EFFORT'}),
                ('type', 'panel/panel.py', {'type': numbers[1][0]}),
            ],
            'A7.7': [('domain', shell, {'domain': '@OTHER@'}), ('range', shell, {'range': 'OFF'})],
            'A7.8': [
                ('name', 'panel/panel.py', {'service': words.misspelt(service, draw)}),
                ('type', 'panel/panel.py', {'package': packages[1]}),
            ],
            'A7.9': [('call', 'panel/panel.py', {'ask': _BLOCK})],
            'A7.12': [
                ('swapped', 'robot/robot.py', {'parent': 'base_link', 'child': 'odom'}),
                ('child', 'robot/robot.py', {'child': words.misspelt('base_link', draw)}),
            ],
        }
        rows = sorted(draw.sample(sorted(possible), 2))
        drawn = {row: draw.choice(possible[row]) for row in rows}
        start = 'robot: python3 robot.py\npanel: python3 panel.py\n'
        self.files = {START: start}
        for file, text in texts.items():
            wrong = {
                key: value for _, where, change in drawn.values() if where == file for key, value in change.items()
            }
            self.files[file] = text.format(**values | wrong)
            if wrong:
                self.repaired[file] = text.format(**values)
        self.task = (
            f'The machine robot publishes {topic}, serves {service}, and says where base_link is in odom: it '
            'drives ahead. The machine panel should print all three, three times a second.'
        )
        self.diagnosis = {
            'faults': [{'row': row, 'cause': cause, 'where': where} for row, (cause, where, _) in drawn.items()]
        }

    def prepare(self) -> None:
        for machine in ('robot', 'panel'):
            self.home(machine).install()

    def show_symptom(self) -> None:
        self.watch(lambda: len(self.lines('panel')) >= 5, 2.0)
        self.show_programs()

    def hangs(self, stacks: list[str]) -> bool:
        """Whether the panel stands in `call`, if it has one."""
        blocks = '.client.call(' in (self.path / 'panel' / 'panel.py').read_text()
        return not blocks or waits_in_call(stacks)

    def works(self, timeout: float) -> Verdict:
        def shown() -> list[str]:
            return [line for line in self.lines('panel') if 'base_link: ' in line]

        def places() -> list[float]:
            return [float(line.split()[-2]) for line in shown() if not line.endswith('-')]

        def good() -> bool:
            return bool(shown()) and ': -' not in shown()[-1] and len(places()) > 1 and places()[-1] > places()[-2] > 0

        works = self.watch(good, timeout)
        return Verdict(works, f'the panel shows "{shown()[-1].partition("]: ")[2]}"' if shown() else 'an empty panel')
