"""Two different faults in one system: one may hide the other. The same system serves exercise 7.8.

A robot and a panel on two machines. What the robot measures, where it begins and what it answers stands in a file of
its own, `SENSOR`, and the numbers of the domains in `ROOMS`: who stages the system may draw these anew, and a repair of
the other files still fits.
"""

import re
from random import Random
from typing import NamedTuple

from helpers.programs.faults import words
from helpers.programs.faults.clocks import SIM_TIME
from helpers.programs.faults.fault import START, Fault, Verdict
from helpers.programs.faults.finding import number_of
from helpers.programs.faults.hang import waits_in_call
from helpers.programs.faults.machine import BASHRC, SETUP
from helpers.programs.faults.rates import ENOUGH, TOO_MANY

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
_SOURCE = f'source ~/{SETUP.format(distro="jazzy")}'
_STEADY = 'Clock(clock_type=ClockType.STEADY_TIME)'
_SHOWN = re.compile(r'(?<!\w)\w+: (\S+), (\S+) a second, \w+: (.+), base_link: (.+)$')
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


class Names(NamedTuple):
    """The names and numbers of one system, right and wrong."""

    robot: str
    topic: str
    service: str
    types: list[tuple[str, str]]  # the topic's type and another, each with what it carries
    packages: list[str]  # the service's package and another
    rooms: list[str]  # the system's and another
    speed: float  # m/s
    period: float  # s: too long
    shell: str  # the machine whose terminal is in the wrong domain
    wrong: dict[str, str]  # for each right name, one that is misspelt
    asleep: dict[str, str]  # which program waits for a clock

    @property
    def signs(self) -> dict[str, str]:
        """For each right name, a pattern of the misspelt one as a whole word: 'pressur' is in 'pressure'."""
        return {word: rf'\b{name}\b' for word, name in self.wrong.items()}


def _draw_names(draw: Random) -> Names:
    robot, topic, service = draw.choice(words.ROBOTS), draw.choice(words.SENSORS)[0], draw.choice(words.SERVICES)[0]
    return Names(
        robot=robot,
        topic=topic,
        service=service,
        types=draw.sample([('Int32', 'sensor.measure()'), ('Float32', 'float(sensor.measure())')], 2),
        packages=draw.sample(['std_srvs', 'example_interfaces'], 2),
        rooms=draw.sample(words.ROOMS, 2),
        speed=draw.randrange(4, 10) / 10,
        period=draw.choice([0.5, 0.8, 1.0]),
        shell=draw.choice([f'robot/{BASHRC}', f'panel/{BASHRC}']),
        wrong={word: words.misspelt(word, draw) for word in (topic, service, 'base_link', robot, 'speed')},
        asleep=draw.choice([{'robot_time': SIM_TIME.removeprefix(' --ros-args')}, {'panel_time': SIM_TIME}]),
    )


def _right_values(names: Names) -> dict[str, object]:
    """What stands in the files where nothing is wrong."""
    return {
        'topic': names.topic,
        'measured': names.topic,
        'asked': names.service,
        'type': names.types[0][0],
        'value': names.types[0][1],
        'reliability': 'RELIABLE',
        'service': names.service,
        'package': names.packages[0],
        'robot': names.robot,
        'node': names.robot,
        'parent': 'odom',
        'child': 'base_link',
        'ask': _ASK,
        'clock': 'self.get_clock()',
        'period': 0.1,
        'parameter': 'speed',
        'speed': names.speed,
        'source': _SOURCE,
        'room': names.rooms[0].upper(),
        'range': 'LOCALHOST',
        'parameters': ' --params-file params.yaml',
        'robot_time': '',
        'panel_time': '',
    }


def _task(names: Names) -> str:
    return (
        f'The machines robot and panel are in the room {names.rooms[0]}. robot publishes {names.topic} '
        f'(std_msgs/msg/{names.types[0][0]}, RELIABLE) ten times a second, serves {names.service} '
        f'({names.packages[0]}/srv/Trigger), and says where base_link is in odom: '
        f'it drives ahead with {names.speed} m/s, as params.yaml says. panel should print all of '
        'it, three times a second.'
    )


def _of_terminals(names: Names) -> dict[str, list[Drawn]]:
    """Faults of what a terminal has sourced and set."""
    other = names.rooms[1].upper()
    return {
        'no_ros2': [
            Drawn('not sourced', f'panel/{BASHRC}', {'source': f'# {_SOURCE}'}, '', ()),
            Drawn('not sourced', f'panel/{BASHRC}', {'source': _SOURCE.replace('jazzy', 'humble')}, '', ()),
        ],
        'unseen': [
            Drawn('domain', names.shell, {'room': other}, f'export ROS_DOMAIN_ID=${other}', (rf'{other}\b',)),
            Drawn('range', names.shell, {'range': 'OFF'}, 'export ROS_AUTOMATIC_DISCOVERY_RANGE=OFF', (r'\bOFF\b',)),
        ],
    }


def _of_wires(names: Names) -> dict[str, list[Drawn]]:
    """Faults of the topic and of the service."""
    topic, service, (_, (other_type, _)), other = names.topic, names.service, names.types, names.packages[1]
    sensed, served = names.wrong[topic], names.wrong[service]
    panel, robot = 'panel/panel.py', 'robot/robot.py'
    trigger = (f'{other}/srv/Trigger', rf'from {other}\.srv')
    return {
        'no_data': [
            Drawn('name', panel, {'topic': sensed}, f'/{sensed}', (names.signs[topic],)),
            Drawn('reliability', robot, {'reliability': 'BEST_EFFORT'}, 'BEST_EFFORT', ('BEST_EFFORT',)),
            Drawn('type', panel, {'type': other_type}, f'std_msgs/msg/{other_type}', (rf'\b{other_type}\b',)),
        ],
        'waiting': [
            Drawn('name', panel, {'service': served}, f'/{served}', (names.signs[service],)),
            Drawn('type', panel, {'package': other}, trigger[0], trigger),
        ],
        'hang': [Drawn('call', panel, {'ask': _BLOCK}, _BLOCK.strip(), (r'in (call|on_timer)\b', r'\.call\('))],
    }


def _of_frames_and_clocks(names: Names) -> dict[str, list[Drawn]]:
    """Faults of the transform from odom to base_link, and of its time."""
    robot, base_link = 'robot/robot.py', names.wrong['base_link']
    turned = (
        r'\[-\d+\.\d',
        r'base_link: -\d',
        r'child_frame_id\W+odom',
        r'(?<!child_)frame_id\W+base_link',
        r'\bodom\W+(n\s+)?parent\W+base_link',  # of view_frames, which prints a new line as \n
        r'\bbase_link"?\s*(→|->\s*")\s*odom',  # of a diagram
    )
    no_clock = (
        r'use_sim_time(?!.*\b[Ff]alse\b)',
        r'\bTrue\b',
        r'/clock(?!.*count: [1-9])',
        r'(?<!Subscription )count: 0',
    )
    return {
        'no_transform': [
            Drawn('exchanged', robot, {'parent': 'base_link', 'child': 'odom'}, "frame_id = 'base_link'", turned),
            Drawn('unknown', robot, {'child': base_link}, base_link, (names.signs['base_link'],)),
        ],
        'wrong_time': [
            Drawn('no clock', START, dict(names.asleep), SIM_TIME.split()[-1], no_clock),
            Drawn('other clock', robot, {'clock': _STEADY}, _STEADY, (r'\bsec: \d{1,8}\b', 'STEADY_TIME')),
        ],
    }


def _of_numbers(names: Names) -> dict[str, list[Drawn]]:
    """Faults of the robot's rate and speed."""
    period, file, zero = names.period, 'robot/params.yaml', r'\b0\.0\b'
    robot, speed = names.wrong[names.robot], names.wrong['speed']
    return {
        'too_slow': [
            Drawn('rate', 'robot/robot.py', {'period': period}, f'{1 / period:.1f}', (rf'create_timer\({period}',))
        ],
        'no_parameter': [
            Drawn('parameter', file, {'node': robot}, '0.0', (zero, names.signs[names.robot])),
            Drawn('parameter', file, {'parameter': speed}, '0.0', (zero, names.signs['speed'])),
            Drawn('parameter', START, {'parameters': ''}, '0.0', (zero,)),
        ],
    }


class Mystery(Fault):
    """A robot and a panel on two machines, with two faults at once; ``kind`` is always ``two``."""

    name, title = 'mystery', 'the panel does not show what it should'
    kinds: tuple[str, ...] = ('two',)
    program = 'panel'

    def plan(self) -> None:
        self.plan_system(self.random.sample(sorted(self._possible(), key=number_of), 2))

    def _possible(self) -> dict[str, list[Drawn]]:
        """What may be wrong, by fault. The names are drawn here."""
        names = _draw_names(self.random)
        self.rooms = names.rooms
        self._values, self.task = _right_values(names), _task(names)
        return {**_of_terminals(names), **_of_wires(names), **_of_frames_and_clocks(names), **_of_numbers(names)}

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
        return (
            'the panel counts less than ten times a second: the robot publishes too seldom, or a callback of the panel '
            'waits'
        )
    if all(_number(line.rate) > TOO_MANY for line in shown):
        return 'the robot publishes more than ten times a second'
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
