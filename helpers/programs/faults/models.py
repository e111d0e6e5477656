"""`no_model` and `falls`: a display that shows no robot, and a robot that does not stand on the floor."""

import re

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict

_URDF = """\
<?xml version="1.0"?>
<robot name="{robot}">
  <link name="base_link">
    <visual><geometry><box size="0.4 0.3 {height}"/></geometry></visual>
  </link>
  <link name="{sensor}">
    <visual><geometry><cylinder radius="0.05" length="0.06"/></geometry></visual>
  </link>
  <joint name="{sensor}_joint" type="fixed">
    <parent link="{parent}"/>
    <child link="{sensor}"/>
    <origin xyz="{x} 0 {height}"/>
  </joint>
</robot>
"""
_VIEWER = '''\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String


class Viewer(Node):
    """Waits for a robot description, as the display RobotModel of RViz does."""

    def __init__(self):
        super().__init__('viewer')
        qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(String, '{topic}', self.on_description, qos)
        self.links = 0
        self.create_timer(0.3, self.on_timer)

    def on_description(self, message):
        self.links = message.data.count('<link ')

    def on_timer(self):
        if self.links:
            self.get_logger().info(f'a robot of {{self.links}} links')
        else:
            self.get_logger().warning('no robot description: nothing to show')


rclpy.init()
try:
    rclpy.spin(Viewer())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
'''
_DROP = """\
import sys

from mujoco_world.world import World

with open(sys.argv[1]) as file:
    world = World(file.read(), scene='empty')
begin = world.pose
world.drive({speed}, 0.0)
for _ in range(4):
    world.run(0.5)
    pose = world.pose
    print(f't = {{world.time:.1f}} s   ahead {{pose.x - begin.x:6.2f}} m   height {{pose.z - begin.z:7.2f}} m   '
          f'pitch {{pose.pitch:5.2f}} rad')
print('done')
"""


class NoModel(Fault):
    """A display gets no robot description.

    Kinds: ``no_publisher`` (nobody started robot_state_publisher), ``namespace`` (it is in one), ``name`` (the display
    listens to a misspelt topic), ``urdf`` (the description is not a robot, so that robot_state_publisher ends).
    """

    name, title = 'no_model', 'the display shows no robot model'
    kinds = ('no_publisher', 'namespace', 'name', 'urdf')

    def plan(self) -> None:
        draw = self.random
        robot, sensor = draw.choice(words.ROBOTS), draw.choice(words.SENSOR_FRAMES)
        values = {
            'robot': robot,
            'sensor': sensor,
            'x': draw.randrange(1, 15) / 100,
            'height': draw.randrange(10, 30) / 100,
            'parent': 'base_link',
        }
        wrong_topic, wrong_link = words.misspelt('robot_description', draw), words.misspelt('base_link', draw)
        publisher = 'ros2 run robot_state_publisher robot_state_publisher robot.urdf'
        sound = {
            START: f'{publisher}\npython3 viewer.py\n',
            'robot.urdf': _URDF.format(**values),
            'viewer.py': _VIEWER.format(topic='/robot_description'),
        }
        change = {
            'no_publisher': (START, f'# {sound[START]}'),
            'namespace': (START, sound[START].replace('.urdf', f'.urdf --ros-args -r __ns:=/{robot}')),
            'name': ('viewer.py', _VIEWER.format(topic=f'/{wrong_topic}')),
            'urdf': ('robot.urdf', _URDF.format(**values | {'parent': wrong_link})),
        }
        where, text = change[self.kind]
        self.files, self.repaired = {**sound, where: text}, {where: sound[where]}
        self.task = 'viewer.py should say that it has a robot of 2 links, as the display RobotModel of RViz would.'
        published = f'/{robot}/robot_description' if self.kind == 'namespace' else '/robot_description'
        cause, evidence = {'no_publisher': ('nobody', ''), 'urdf': ('unknown', wrong_link)}.get(
            self.kind, ('name', published)
        )
        self.diagnose(where, cause, evidence)
        self.facts = {'published': published if cause == 'name' else ''}

    def show_symptom(self) -> None:
        publisher = 'robot_state_publisher'

        def up() -> bool:
            said = publisher not in self.programs or len(self.lines(publisher)) >= 2
            return said and len(self.lines('viewer')) >= 3

        self.watch(up, self.patience, ends=(publisher,))
        self.show_programs()

    def works(self, timeout: float) -> Verdict:
        shown = self.watch(lambda: any('a robot of 2 links' in line for line in self.lines('viewer')), timeout)
        return Verdict(shown, f'viewer.py {"has" if shown else "has not"} got the robot')


class Falls(Fault):
    """A robot does not stand on the floor of a simulator, or does not drive.

    Kinds: ``no_collision`` (nothing of it touches), ``wheels`` (its wheels do not), ``no_inertial`` (its body has no
    mass), ``mass`` (it has far too much).
    """

    name, title = 'falls', 'the robot falls through the floor of the simulator, or does not drive'
    kinds = ('no_collision', 'wheels', 'no_inertial', 'mass')

    def plan(self) -> None:
        import mobile_robot_description

        draw = self.random
        robot, speed = draw.choice(words.ROBOTS), draw.choice([0.2, 0.25, 0.3, 0.35])
        mass = draw.choice([2000, 3000, 5000, 8000])
        urdf = mobile_robot_description.urdf().replace('name="mobile_robot"', f'name="{robot}"')
        body = next(part for part in _links(urdf) if 'name="base_link"' in part)
        broken = {
            'no_collision': _without(urdf, 'collision'),
            'wheels': ''.join(_without(part, 'collision') if 'wheel"' in part else part for part in _links(urdf)),
            'no_inertial': urdf.replace(body, _without(body, 'inertial')),
            'mass': urdf.replace(body, re.sub(r'<mass value=".*?"/>', f'<mass value="{mass}"/>', body)),
        }
        self.files = {
            START: 'python3 drop.py robot.urdf\n',
            'drop.py': _DROP.format(speed=speed),
            'robot.urdf': broken[self.kind],
        }
        self.repaired = {'robot.urdf': urdf}
        self.way = 2.0 * speed
        self.task = (
            f'drop.py puts the robot on the floor and drives ahead with {speed} m/s for 2 s. It should stand, '
            f'and come about {self.way:.1f} m far.'
        )
        causes = {'no_collision': 'collision', 'wheels': 'collision', 'no_inertial': 'inertial', 'mass': 'mass'}
        self.diagnose('robot.urdf', causes[self.kind], f'{mass}' if self.kind == 'mass' else '')

    def show_symptom(self) -> None:
        self.watch(self._ended, 30.0, ends=('drop',))
        print(self.programs['drop'].output)

    def works(self, timeout: float) -> Verdict:
        self.watch(self._ended, timeout, ends=('drop',))
        found = [line for line in self.lines('drop') if line.startswith('t = ')]
        if not found or 'done' not in self.lines('drop'):
            return Verdict(False, 'the simulator did not get to the end')
        ahead, height, pitch = (float(found[-1].split(word)[1].split()[0]) for word in ('ahead', 'height', 'pitch'))
        good = abs(height) < 0.01 and abs(pitch) < 0.05 and abs(ahead - self.way) < 0.2 * self.way
        return Verdict(
            good,
            'the robot stands on the floor, and comes as far as it should'
            if good
            else f'after 2 s it is {ahead:.1f} m ahead, at a height of {height:.1f} m',
        )

    def _ended(self) -> bool:
        return not self.programs['drop'].running


def _links(urdf: str) -> list[str]:
    """The text, cut before each link."""
    return re.split(r'(?=<link )', urdf)


def _without(urdf: str, element: str) -> str:
    """The text without all elements of a name, each with the spaces before it."""
    return re.sub(rf'(?<!\s)\s*<{element}>.*?</{element}>', '', urdf, flags=re.DOTALL)
