"""What the tests of exercises 8.7 to 8.11 share: the robot that the learner's node drives, and the package, built."""

import json
import math
from pathlib import Path

from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation

from helpers.runner import expect
from helpers.runner.workspaces import Workspace, package

HERE = Path(__file__).parent
GIVEN = HERE / 'given' / 'delivery_robot'
STEERING, NODE = 'delivery_robot/steering.py', 'delivery_robot/robot.py'
CELLS = {STEERING: ('8.5',), NODE: ('8.7', '8.8', '8.9')}  # the exercises whose cells become a module


def cell_text(exercise: str) -> str:
    """The newest text of an exercise's cell that this kernel has run.

    :raises LookupError: it has not been run.
    """
    from helpers import journal
    from helpers.exercises import notebooks, program

    for noted in reversed(journal.cells):
        if program.exercise_id(notebooks.Cell(noted.source, 0, noted.id)) == exercise:
            return noted.source.strip()
    raise LookupError(f'run the cell of exercise {exercise} first')


# The node by itself


class Localizer:
    """Tells the learner's node where base_footprint is in the map, by way of odom."""

    def __init__(self, learner, drift: tuple[float, float, float] = (0.0, 0.0, 0.0)):
        """:param drift: the place of odom in the map: x, y in metres, yaw in radians."""
        from helpers.runner.frames import pose

        self._tf = learner.tf_broadcaster()
        self._pose, self._drift = pose, pose(drift[0], drift[1], yaw=drift[2])

    def tell(self, x: float, y: float, yaw: float, seconds: float | None = None) -> None:
        """Stamped now, or as given (simulated seconds)."""
        import numpy

        self._tf.send('map', 'odom', self._drift, seconds)
        self._tf.send('odom', 'base_footprint', numpy.linalg.inv(self._drift) @ self._pose(x, y, yaw=yaw), seconds)


def where(node):
    """What the learner's `where` returns: None, or a list of three numbers."""
    found = node.call('where')
    if found is not None:
        expect(isinstance(found, (list, tuple)) and len(found) == 3
               and all(type(one) in (int, float) and math.isfinite(one) for one in found),
               f'where() is {found!r}, expected (x, y, yaw) or None.')
    return found


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
        expect(response.success, f'The service set_station refused {name} at ({x:g}, {y:g}).')
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

    def near(self, station: str, metres: float) -> None:
        """Fail unless the robot is nearer to a station than this."""
        distance = self.distance(station)
        expect(distance < metres, f'The robot is {distance:.2f} m from {station}, expected less than {metres:g} m.')

    def stands(self, after: str) -> None:
        """Fail unless the last command was one of zeros, and no other one comes; `after`: what has happened."""
        commands = self.robot.commands
        last = commands.messages[-1] if len(commands) else None
        expect(last and (last.linear.x, last.angular.z) == (0.0, 0.0),
               f'{after}, and the last command still drives. Before every end: drive(0.0, 0.0).')
        count = len(commands)
        self.run(0.4)
        expect(len(commands) == count, f'{after}, and {len(commands) - count} more commands came on cmd_vel.')


# The package


def modules(learner) -> dict[str, str]:
    """The modules of the package, with the learner's cells in them: path in the package → text."""
    found = {}
    for path in sorted((GIVEN / 'delivery_robot').glob('*.py')):
        module = f'delivery_robot/{path.name}'
        cells = [part['source'].strip() + '\n\n\n' for exercise in CELLS.get(module, ())
                 for part in learner.program['cells'] if part['label'] == f'Exercise {exercise}']
        found[module] = path.read_text() + ('\n\n' + ''.join(cells) if cells else '')
    return found


def files(learner) -> dict[str, str]:
    """The package with the learner's cells and texts, as `learner.workspace` wants it."""
    top = 'src/delivery_robot'
    found = {**package(GIVEN), **{f'{top}/{path}': text for path, text in modules(learner).items()}}
    return {**found, f'{top}/config/delivery.yaml': learner.text('DELIVERY_YAML'),
            f'{top}/launch/delivery.launch.py': learner.text('DELIVERY_LAUNCH'),
            'deliver.py': (HERE / 'deliver.py').read_text()}


def workspace(learner) -> Workspace:
    """The learner's package, built."""
    found = learner.workspace(files(learner))
    found.build('--packages-select', 'delivery_robot')
    return found


def launched(learner) -> dict:
    """What happened when the learner's package was launched and used: see deliver.py. Once for all tests."""
    done = workspace(learner).run('bash', '-c', 'if [ ! -e story.json ]; then mv src sources; python3 deliver.py; '
                                  'mv sources src; fi\ncat launch.txt; echo ---; cat story.json', timeout=100)
    log, _, story = done.output.rpartition('---')
    expect(story.strip().startswith('{'), f'The run of your package ended with: {done.last_line}')
    return {**json.loads(story), 'log': log, 'last': _last(log)}


def _last(log: str) -> str:
    """The line of a launch's output that tells most: an error of the learner's program, or else the last one."""
    lines = [line.strip() for line in log.splitlines() if line.strip() and 'process has died' not in line]
    telling = [line for line in lines if 'Error' in line or 'Exception' in line]
    return (telling or lines or ['nothing'])[-1][:300]
