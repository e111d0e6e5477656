"""Two different faults in one system: one may hide the other. The same system serves exercise 7.8.

A robot and a panel on two machines. What the robot measures, where it begins and what it answers stands in a file of
its own, `SENSOR`, and the numbers of the domains in `ROOMS`: who stages the system may draw these anew, and a repair of
the other files still fits.
"""

import re
from typing import NamedTuple

from helpers.programs.faults import words
from helpers.programs.faults.clocks import SIM_TIME
from helpers.programs.faults.fault import START, Fault, Verdict
from helpers.programs.faults.finding import number_of
from helpers.programs.faults.hang import waits_in_call
from helpers.programs.faults.machine import BASHRC, SETUP
from helpers.programs.faults.rates import ENOUGH

MACHINES = ('robot', 'panel')
SENSOR, ROOMS = 'sensor.py', 'rooms.sh'

_SHELL = """\
{source}
source ~/rooms.sh  # which room has which domain
export ROS_DOMAIN_ID=${room}
export ROS_AUTOMATIC_DISCOVERY_RANGE={range}
"""
_SENSOR = '''\
"""The sensor, the place where the robot begins, and its answer. This is not where the fault is."""

import itertools

ANSWER, BEGIN = {answer!r}, {begin}
measure = itertools.count({first}).__next__
'''
_ROBOT = """\
import time

import rclpy
import sensor
from geometry_msgs.msg import TransformStamped
from rclpy.clock import Clock, ClockType
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
        self.declare_parameter('speed', 0.0)
        self.clock = {clock}
        self.x, self.last = sensor.BEGIN, time.monotonic()
        self.create_timer({period}, self.on_timer)
        self.get_logger().info('ready')

    def on_timer(self):
        self.publisher.publish({type}(data={value}))
        seconds, self.last = time.monotonic() - self.last, time.monotonic()
        self.x += self.get_parameter('speed').value * seconds  # metres: it drives ahead
        transform = TransformStamped()
        transform.header.stamp = self.clock.now().to_msg()
        transform.header.frame_id = '{parent}'
        transform.child_frame_id = '{child}'
        transform.transform.translation.x = self.x
        transform.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(transform)

    def on_request(self, request, response):
        response.success, response.message = True, sensor.ANSWER
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
    """All on one line; what is not known is a dash."""

    def __init__(self):
        super().__init__('panel')
        qos = QoSProfile(depth=5, reliability=ReliabilityPolicy.{reliability})
        self.create_subscription({type}, '{topic}', self.on_message, qos)
        self.client = self.create_client(Trigger, '{service}')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.value = self.rate = self.answer = '-'
        self.sent = []  # when the last messages were sent, in seconds
        self.create_timer(0.3, self.on_timer)
        self.get_logger().info('ready')

    def on_message(self, message, info):
        self.value = f'{{message.data:.0f}}'
        self.sent = [*self.sent[-5:], info['source_timestamp'] / 1e9]
        if len(self.sent) > 1:
            self.rate = f'{{(len(self.sent) - 1) / (self.sent[-1] - self.sent[0]):.1f}}'

    def on_answer(self, future):
        self.answer = future.result().message

    def place(self):
        try:
            found = self.buffer.lookup_transform('odom', 'base_link', Time())
        except TransformException:
            return '-'
        age = self.get_clock().now() - Time.from_msg(found.header.stamp)
        old = abs(age.nanoseconds) > 3e9
        return 'too old' if old else f'{{found.transform.translation.x:.2f}} m'

    def on_timer(self):
        if self.client.service_is_ready():
{ask}
        measured = f'{measured}: {{self.value}}, {{self.rate}} a second'
        self.get_logger().info(f'{{measured}}, {asked}: {{self.answer}}, base_link: {{self.place()}}')


rclpy.init()
try:
    rclpy.spin(Panel())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
'''
_PARAMETERS = '{node}:\n  ros__parameters:\n    {parameter}: {speed}  # m/s\n'
_START = """\
robot: python3 robot.py --ros-args{parameters}{robot_time}
panel: python3 panel.py{panel_time}
"""
_ASK = '            self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)'
_BLOCK = '            self.answer = self.client.call(Trigger.Request()).message'
_STEADY = 'Clock(clock_type=ClockType.STEADY_TIME)'
_SHOWN = re.compile(r'\w+: (\S+), (\S+) a second, \w+: (.+), base_link: (.+)$')
_LINES = 8  # of the panel, in which something must have changed: more than two seconds


class Drawn(NamedTuple):
    """A fault that this system may have."""

    cause: str
    where: str
    change: dict[str, object]  # what is different in that file
    evidence: str
    shows: tuple[str, ...]  # patterns, of which an evidence in somebody's own words has at least one


class Shown(NamedTuple):
    """A line of the panel."""

    value: str
    rate: str
    answer: str
    place: str


class Mystery(Fault):
    """A robot and a panel on two machines, with two faults at once; ``kind`` is always ``two``."""

    name, title = 'mystery', 'the panel does not show what it should'
    kinds: tuple[str, ...] = ('two',)
    program = 'panel'

    def plan(self) -> None:
        self.plan_system(self.random.sample(sorted(self._possible(), key=number_of), 2))

    def _possible(self) -> dict[str, list[Drawn]]:
        """What may be wrong, by fault. The names are drawn here."""
        draw = self.random
        robot, topic, service = (
            draw.choice(words.ROBOTS),
            draw.choice(words.SENSORS)[0],
            draw.choice(words.SERVICES)[0],
        )
        numbers = draw.sample([('Int32', 'sensor.measure()'), ('Float32', 'float(sensor.measure())')], 2)
        packages = draw.sample(['std_srvs', 'example_interfaces'], 2)
        self.rooms = draw.sample(words.ROOMS, 2)
        room, other = (name.upper() for name in self.rooms)
        speed, period = draw.randrange(4, 10) / 10, draw.choice([0.5, 0.8, 1.0])
        self._values: dict[str, object] = {
            'topic': topic,
            'measured': topic,
            'asked': service,
            'type': numbers[0][0],
            'value': numbers[0][1],
            'reliability': 'RELIABLE',
            'service': service,
            'package': packages[0],
            'robot': robot,
            'node': robot,
            'parent': 'odom',
            'child': 'base_link',
            'ask': _ASK,
            'clock': 'self.get_clock()',
            'period': 0.1,
            'parameter': 'speed',
            'speed': speed,
            'source': f'source ~/{SETUP.format(distro="jazzy")}',
            'room': room,
            'range': 'LOCALHOST',
            'parameters': ' --params-file params.yaml',
            'robot_time': '',
            'panel_time': '',
        }
        self.task = (
            f'The machines robot and panel are in the room {self.rooms[0]}. robot publishes {topic} '
            f'(std_msgs/msg/{numbers[0][0]}, RELIABLE) ten times a second, serves {service} '
            f'({packages[0]}/srv/Trigger), and says where base_link is in odom: '
            f'it drives ahead with {speed} m/s, as params.yaml says. panel should print all of '
            'it, three times a second.'
        )
        shell = draw.choice([f'robot/{BASHRC}', f'panel/{BASHRC}'])
        wrong = {word: words.misspelt(word, draw) for word in (topic, service, 'base_link', robot, 'speed')}
        sign = {word: rf'\b{name}\b' for word, name in wrong.items()}  # 'pressur' is in 'pressure'
        asleep = draw.choice([{'robot_time': SIM_TIME.removeprefix(' --ros-args')}, {'panel_time': SIM_TIME}])
        source = str(self._values['source'])
        return {
            'no_ros2': [
                Drawn('not sourced', f'panel/{BASHRC}', {'source': f'# {source}'}, '', ()),
                Drawn('not sourced', f'panel/{BASHRC}', {'source': source.replace('jazzy', 'humble')}, '', ()),
            ],
            'no_data': [
                Drawn('name', 'panel/panel.py', {'topic': wrong[topic]}, f'/{wrong[topic]}', (sign[topic],)),
                Drawn('reliability', 'robot/robot.py', {'reliability': 'BEST_EFFORT'}, 'BEST_EFFORT', ('BEST_EFFORT',)),
                Drawn(
                    'type',
                    'panel/panel.py',
                    {'type': numbers[1][0]},
                    f'std_msgs/msg/{numbers[1][0]}',
                    (rf'\b{numbers[1][0]}\b',),
                ),
            ],
            'unseen': [
                Drawn('domain', shell, {'room': other}, f'export ROS_DOMAIN_ID=${other}', (rf'{other}\b',)),
                Drawn('range', shell, {'range': 'OFF'}, 'export ROS_AUTOMATIC_DISCOVERY_RANGE=OFF', (r'\bOFF\b',)),
            ],
            'waiting': [
                Drawn('name', 'panel/panel.py', {'service': wrong[service]}, f'/{wrong[service]}', (sign[service],)),
                Drawn(
                    'type',
                    'panel/panel.py',
                    {'package': packages[1]},
                    f'{packages[1]}/srv/Trigger',
                    (f'{packages[1]}/srv/Trigger', rf'from {packages[1]}\.srv'),
                ),
            ],
            'hang': [
                Drawn('call', 'panel/panel.py', {'ask': _BLOCK}, _BLOCK.strip(), (r'in (call|on_timer)\b', r'\.call\('))
            ],
            'no_transform': [
                Drawn(
                    'exchanged',
                    'robot/robot.py',
                    {'parent': 'base_link', 'child': 'odom'},
                    "frame_id = 'base_link'",
                    (r'\[-\d+\.\d', r'base_link: -\d', r'child_frame_id\W+odom', r'(?<!child_)frame_id\W+base_link'),
                ),
                Drawn(
                    'unknown', 'robot/robot.py', {'child': wrong['base_link']}, wrong['base_link'], (sign['base_link'],)
                ),
            ],
            'wrong_time': [
                Drawn(
                    'no clock',
                    START,
                    asleep,
                    SIM_TIME.split()[-1],
                    (
                        r'use_sim_time(?!.*\b[Ff]alse\b)',
                        r'\bTrue\b',
                        r'/clock(?!.*count: [1-9])',
                        r'(?<!Subscription )count: 0',
                    ),
                ),
                Drawn(
                    'other clock', 'robot/robot.py', {'clock': _STEADY}, _STEADY, (r'\bsec: \d{1,8}\b', 'STEADY_TIME')
                ),
            ],
            'too_slow': [
                Drawn('rate', 'robot/robot.py', {'period': period}, f'{1 / period:.1f}', (rf'create_timer\({period}',))
            ],
            'no_parameter': [
                Drawn('parameter', 'robot/params.yaml', {'node': wrong[robot]}, '0.0', (r'\b0\.0\b', sign[robot])),
                Drawn(
                    'parameter', 'robot/params.yaml', {'parameter': wrong['speed']}, '0.0', (r'\b0\.0\b', sign['speed'])
                ),
                Drawn('parameter', START, {'parameters': ''}, '0.0', (r'\b0\.0\b',)),
            ],
        }

    def plan_system(self, faults: list[str]) -> None:
        """Write the system down with these faults."""
        possible = self._possible()
        # In the order of the earlier numbers: a seed draws what it drew before faults had names.
        self.drawn = {fault: self.random.choice(possible[fault]) for fault in sorted(faults, key=number_of)}
        texts = {
            START: _START,
            f'robot/{BASHRC}': _SHELL,
            f'panel/{BASHRC}': _SHELL,
            'robot/robot.py': _ROBOT,
            'robot/params.yaml': _PARAMETERS,
            'panel/panel.py': _PANEL,
        }
        self.files, self.repaired = {}, {}
        for file, text in texts.items():
            wrong = {
                key: value for one in self.drawn.values() if one.where == file for key, value in one.change.items()
            }
            self.files[file] = text.format(**self._values | wrong)
            if wrong:
                self.repaired[file] = text.format(**self._values)
        for fault, found in self.drawn.items():
            self.diagnose(found.where, found.cause, found.evidence, fault)

    def given(self, answer: str = 'done', begin: float = 1.0, first: int = 10) -> dict[str, str]:
        """The files that nobody changes, for the robot: what its sensor says. `first` is the first measurement."""
        return {SENSOR: _SENSOR.format(answer=answer, begin=begin, first=first)}

    def rooms_text(self, domain: str, other: str) -> str:
        """The file with the domains of the rooms, for both machines: that of the system's own, and the other one."""
        numbers = sorted(zip((room.upper() for room in self.rooms), (domain, other), strict=True))
        return ''.join(f'{room}={number}\n' for room, number in numbers)

    def prepare(self) -> None:
        for machine in MACHINES:
            self.home(machine).install()
            self.home(machine).write(ROOMS, self._fill(self.rooms_text('@DOMAIN@', '@OTHER@')))
        for file, text in self.given().items():
            self.home('robot').write(file, text)

    def show_symptom(self) -> None:
        self.watch(lambda: len(self.lines('panel')) >= 8, 3.0)
        self.show_programs()

    def hangs(self, stacks: list[str]) -> bool:
        """Whether the panel stands in `call`, if it has one."""
        blocks = '.client.call(' in (self.path / 'panel' / 'panel.py').read_text()
        return not blocks or waits_in_call(stacks)

    def works(self, timeout: float) -> Verdict:
        works = self.watch(lambda: not lacks(self.lines('panel')), timeout)
        shown = [line for line in self.lines('panel') if _SHOWN.search(line)]
        return Verdict(works, f'the panel shows "{shown[-1].partition("]: ")[2]}"' if shown else 'an empty panel')


def lines_of_panel(output: list[str]) -> list[Shown]:
    """What the panel has shown, line by line."""
    return [Shown(*found.groups()) for line in output if (found := _SHOWN.search(line))]


def lacks(output: list[str], answer: str = '', begin: float = 0.0, first: int = 0) -> str:
    """What the panel's last lines lack, in words for a learner; '' if it shows all that it should.

    :param answer: what the robot's service says, if that is known; ``begin``: where it begins, in m; ``first``: its
        first measurement.
    """
    shown = lines_of_panel(output)[-_LINES:]
    if len(shown) < 3:
        return 'it prints hardly anything'
    last = shown[-1]
    if not last.value.isdecimal() or int(last.value) < first:
        return 'what the robot measures is not there'
    if not any(_number(line.rate) > ENOUGH for line in shown):
        return 'the robot publishes less than ten times a second'
    if last.answer == '-' or answer and last.answer != answer:
        return 'the answer of the service is not there'
    known = [line.place for line in shown if line.place.endswith(' m')]  # others are not known yet, or too old
    places = [_number(place.removesuffix(' m')) for place in known]
    if len(places) < 2 or last.place != known[-1] or not places[-1] > max(begin, places[0]):
        return 'base_link does not drive ahead from where it begins'
    return ''


def _number(text: str) -> float:
    """A number that somebody has printed; -1 if it is none."""
    try:
        return float(text)
    except ValueError:
        return -1.0
