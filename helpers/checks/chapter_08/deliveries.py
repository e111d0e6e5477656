"""What the tests of exercises 8.7 to 8.11 share: the robot that the learner's node drives, and the package, built."""

import hashlib
import json
import math
import secrets
import signal
from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation

from helpers.checks.chapter_08 import launch_output, parameter_files
from helpers.runner import expect, stand_ins
from helpers.runner.load import busy
from helpers.runner.observer import Observer
from helpers.runner.stand_ins import Start
from helpers.runner.workspaces import ExerciseWorkspace, package

PATIENCE = 20.0  # s of wall time until a node has said what parameters it has
HERE = Path(__file__).parent
GIVEN = HERE / 'given' / 'delivery_robot'
MAIN = 'src/delivery_robot/delivery_robot/main.py'
STEERING, NODE = 'delivery_robot/steering.py', 'delivery_robot/robot.py'
# A node that only has parameters, and prints them.
_REPORT = """
import json, rclpy

rclpy.init()
node = rclpy.create_node('delivery_robot')
found = {{name: node.declare_parameter(name, value).value for name, value in {defaults!r}.items()}}
print({mark!r} + json.dumps(found), flush=True)
rclpy.shutdown()
"""
# Prints the arguments of the launch file, as `ros2 launch --show-args` finds them; the launch file prints nothing.
_DECLARED = """
import json, os

from ament_index_python.packages import get_package_share_directory
from launch.launch_description_sources import get_launch_description_from_any_launch_file

output, nowhere = os.dup(1), os.open(os.devnull, os.O_WRONLY)
for descriptor in (1, 2):
    os.dup2(nowhere, descriptor)
path = get_package_share_directory('delivery_robot') + '/launch/delivery.launch.py'
found = {{}}
for argument in get_launch_description_from_any_launch_file(path).get_launch_arguments():
    found[argument.name] = ''.join(part.describe().strip("'") for part in argument.default_value or ())
os.write(output, f'{mark}{{json.dumps(found)}}\\n'.encode())
"""
# Behind the text of world.launch.py: who includes it has this line in the launch's output.
_INCLUDED = """


plain = generate_launch_description


def generate_launch_description() -> LaunchDescription:
    from launch.actions import LogInfo

    return LaunchDescription([LogInfo(msg={mark!r}), *plain().entities])
"""
CELLS = {STEERING: ('8.5',), NODE: ('8.7', '8.8', '8.9')}  # the exercises whose cells become a module


# The node by itself


class Localizer:
    """Tells the learner's node where base_footprint is in the map, by way of odom."""

    def __init__(self, learner, drift: tuple[float, float, float] = (0.0, 0.0, 0.0)):
        """:param drift: the place of odom in the map: x, y in metres, yaw in radians."""
        from helpers.runner.frames import pose

        self._tf = learner.tf_broadcaster()
        self._pose = pose
        self._driven = pose()  # where base_footprint is in odom
        self.drift(*drift)

    def drift(self, x: float, y: float, yaw: float) -> None:
        """From now on, odom is here in the map. Nobody is told yet."""
        self._drift = self._pose(x, y, yaw=yaw)

    def correct(self, x: float, y: float, yaw: float) -> tuple[float, float, float]:
        """Tell that odom is here in the map, and the robot where it was in odom. Returns its x, y, yaw in the map."""
        self.drift(x, y, yaw)
        self.localize()
        self._tf.send('odom', 'base_footprint', self._driven)
        there = self._drift @ self._driven
        return float(there[0, 3]), float(there[1, 3]), math.atan2(there[1, 0], there[0, 0])

    def tell(self, x: float, y: float, yaw: float, seconds: float | None = None) -> None:
        """Stamped now, or as given (simulated seconds)."""
        self.localize(seconds)
        self.move(x, y, yaw, seconds)

    def localize(self, seconds: float | None = None) -> None:
        """Only where odom is in the map."""
        self._tf.send('map', 'odom', self._drift, seconds)

    def move(self, x: float, y: float, yaw: float, seconds: float | None = None, parent: str = 'odom') -> None:
        """Only where base_footprint is in odom, so that it is here in the map."""
        import numpy

        self._driven = numpy.linalg.inv(self._drift) @ self._pose(x, y, yaw=yaw)
        self._tf.send(parent, 'base_footprint', self._driven, seconds)


class Delivery:
    """The learner's DeliveryRobot in the simulated world, with what people do with it."""

    def __init__(self, learner, parameters: dict | None = None, **robot):
        """:param parameters: of the node. :param robot: of `MobileRobot`."""
        from helpers.runner.mobile_robot import MobileRobot

        self._learner = learner
        self.client = learner.action_client('/go_to_station', GoToStation)
        self._set = learner.client('/set_station', SetStation)
        self.robot = MobileRobot(learner, **robot)
        self.places: dict[str, tuple[float, float]] = {}
        self.node = learner.start('DeliveryRobot', threads=True, parameters=parameters)
        learner.run(0.3)

    def station(self, name: str, x: float, y: float) -> None:
        """Set a station; fail if it is refused."""
        response = self._set.call(name=name, x=x, y=y)
        expect(
            response.success,
            f'The service set_station refused {name} at ({x:g}, {y:g}). Look at exercise 8.7.',
            'rejects-unknown',
        )
        self.places[name] = x, y

    def go(self, station: str):
        """Send a goal; it is answered when this returns."""
        goal = self.client.send(station=station)
        self._learner.settle()
        return goal

    def run(self, seconds: float, goal=None) -> None:
        """Let time pass, at most until the goal is done."""
        self._learner.run(seconds, until=goal and (lambda: goal.done))

    def distance(self, station: str) -> float:
        """Metres from the robot to a station."""
        return self.robot.distance(*self.places[station])


# The package


def modules(learner) -> dict[str, str]:
    """The modules of the package, with the learner's cells in them: path in the package → text."""
    found = {}
    for path in sorted((GIVEN / 'delivery_robot').glob('*.py')):
        module = f'delivery_robot/{path.name}'
        cells = [
            part['source'].strip() + '\n\n\n'
            for exercise in CELLS.get(module, ())
            for part in learner.program['cells']
            if part['label'] == f'Exercise {exercise}'
        ]
        found[module] = path.read_text() + ('\n\n' + ''.join(cells) if cells else '')
    return found


def files(learner) -> dict[str, str]:
    """The package with the learner's cells and texts, as `learner.workspace` wants it.

    Its executable is a stand-in, and so is that of the world: the tests start both elsewhere.
    """
    top, heard = 'src/delivery_robot', stand_ins.of(learner)
    found = {**package(GIVEN), **{f'{top}/{path}': text for path, text in modules(learner).items()}}
    return {
        **found,
        **_world(heard.text('world')),
        MAIN: f'{found[MAIN]}\n\n{heard.text("robot")}',
        f'{top}/config/delivery.yaml': learner.text('DELIVERY_YAML'),
        f'{top}/launch/delivery.launch.py': learner.text('DELIVERY_LAUNCH'),
    }


def _world(stand_in: str) -> dict[str, str]:
    """An installed package mujoco_world, before the machine's, which has its files and this program."""
    top, name = Path(get_package_share_directory('mujoco_world')), 'mujoco_world'
    share = f'install/{name}/share'
    launch = f'{share}/{name}/launch/world.launch.py'
    found = {
        f'{share}/colcon-core/packages/{name}': '',
        f'{share}/ament_index/resource_index/packages/{name}': '',
        f'{share}/{name}/hook/ament_prefix_path.dsv': '',
        **{
            f'{share}/{name}/{path.relative_to(top)}': path.read_text()
            for path in (top / 'package.xml', *(top / 'launch').glob('*.py'), *(top / 'scenes').glob('*.yaml'))
        },
        f'install/{name}/lib/{name}/world': f'#!/usr/bin/env python3\n{stand_in}\n\nmain()\n',
    }
    return {**found, launch: found[launch] + _INCLUDED.format(mark=_mark(stand_in))}


def _mark(stand_in: str) -> str:
    """The line that tells whether world.launch.py was included; another one in each session."""
    return f'the world is included: {hashlib.sha256(stand_in.encode()).hexdigest()[:12]}'


def workspace(learner) -> ExerciseWorkspace:
    """The learner's package, built."""
    found = learner.workspace(files(learner))
    found.build('--packages-select', 'delivery_robot')
    return found


def launched(learner) -> dict:
    """What happened when the learner's package was launched and used: see deliver.py. Once for all tests."""
    from helpers.checks.chapter_08 import deliver

    place, known = workspace(learner), learner.server.workspaces
    key = 'story', place.name
    if key not in known:
        known[key] = deliver.story(learner, place, modules(learner))
    told = known[key]
    return {
        **told,
        'last': launch_output.telling(told['log']),
        'included': _mark(stand_ins.of(learner).text('world')) in told['log'],
    }


def declared(learner) -> dict[str, str]:
    """The arguments that the learner's launch file declares: name → default value. Once for all tests.

    What it prints while it is read is not looked at: it is not asked for anything.
    """
    place, known = workspace(learner), learner.server.workspaces
    key = 'declared', place.name
    if key not in known:
        mark = f'found {secrets.token_hex(8)} '
        done = place.run(program=_DECLARED.format(mark=mark))
        told = [line.removeprefix(mark) for line in done.lines if line.startswith(mark.strip())]
        known[key] = json.loads(told[0]) if told else {}
    return known[key]


def launched_plainly(learner) -> tuple[str, dict]:
    """What the launch has printed, if it ends by itself before the world has started, and what the world gets then.

    The launch gets no arguments.
    """
    place, heard = workspace(learner), stand_ins.of(learner)
    heard.release()
    launch = place.start('ros2', 'launch', 'delivery_robot', 'delivery.launch.py')
    with Observer(learner) as observer:
        observer.until(lambda: heard.starts('world'), PATIENCE, launch)
    worlds = heard.starts('world')
    ended = not worlds and launch.wait(0) is not None
    launch.signal(signal.SIGINT)
    heard.release()
    launch.wait(5.0)
    launch.end()
    return launch.output if ended else '', parameter_files.given_besides(worlds[:1], '')


def by_the_file(learner, defaults: dict[str, float]) -> dict:
    """The parameters of a node that is started with the learner's DELIVERY_YAML, and without the launch file.

    Once for all tests; the rule `types`.
    """
    text, known = learner.text('DELIVERY_YAML'), learner.server.workspaces
    key = 'by the file', text
    if key not in known:
        known[key] = _by_the_file(learner, text, defaults)
    found, output = known[key]
    for word, why in (
        (
            'InvalidParameterTypeException',
            f'A value in DELIVERY_YAML has the wrong type.{launch_output.wrong_type(output)} All are doubles: 30.0, '
            'not 30.',
        ),
        ("Couldn't parse params file", f'ROS cannot read DELIVERY_YAML. {parameter_files.why_unreadable(text)}'),
    ):
        expect(word not in output, f'With your parameter file, no node starts. {why}', 'types')
    expect(found, f'A node with your parameter file ended with: {launch_output.telling(output)}', 'types')
    return json.loads(found)


def _by_the_file(learner, text: str, defaults: dict[str, float]) -> tuple[str, str]:
    """What a node has said that was started with this file: its parameters as JSON, and all of it."""
    mark = f'found {secrets.token_hex(8)} '
    start = Start('robot', ('--ros-args', stand_ins.FILE_OPTION, 'own.yaml'), {'own.yaml': text})
    task = start.begin(learner, _REPORT.format(mark=mark, defaults=defaults))
    if task.wait(PATIENCE) is None and busy():
        task.wait(3 * PATIENCE)
    task.end()
    told = [line.removeprefix(mark) for line in task.output.splitlines() if line.startswith(mark)]
    return (told or [''])[0], task.output
