"""Launches the package delivery_robot and uses it as people would, over ROS, from the tests' side: what happened.

What the launch file starts as robot and as world, the tests start in the same way elsewhere. Each step waits for a
condition, with a bound; a step that fails ends the story with the name of what was missing. Places and pace are drawn:
a story that is told in advance is another.
"""

import secrets
import signal
import time
from collections import Counter
from pathlib import Path

from action_msgs.msg import GoalStatus
from ament_index_python.packages import get_package_share_directory
from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation
from rclpy.action import ActionClient
from std_msgs.msg import String

from helpers.checks.chapter_08 import hurried_launch, parameter_files
from helpers.runner import stand_ins
from helpers.runner.fork_client import Task
from helpers.runner.load import busy
from helpers.runner.observer import Observer, processes
from helpers.runner.retracing import Way
from helpers.runner.stand_ins import Start

PATIENCE = 25.0  # s of wall time for a step
TRIES = 5
FACTORS = 0.7, 0.75, 0.8, 0.85  # simulated seconds in a second: slower than real time leaves the programs more of it
SLOWER = 0.4  # times these on a busy machine: a right robot is lost if it hears nothing for half a simulated second
STATUS = {
    GoalStatus.STATUS_SUCCEEDED: 'succeeded',
    GoalStatus.STATUS_CANCELED: 'canceled',
    GoalStatus.STATUS_ABORTED: 'aborted',
}
DRAWN = {  # the robot's parameters: from, to; none of these is a default, or a value of the card
    'max_linear': (0.42, 0.48),
    'tolerance': (0.11, 0.14),
    'timeout': (35.0, 50.0),
    'max_angular': (1.1, 1.4),
    'status_period': (0.3, 0.45),
}
_ROBOT, _WORLD = '/delivery_robot', '/world'
VALUES = {
    _ROBOT: ('max_linear', 'max_angular', 'tolerance', 'timeout', 'status_period', 'use_sim_time'),
    _WORLD: ('scene', 'real_time_factor'),
}
PROGRAMS = {
    _ROBOT: ('robot', 'from delivery_robot.main import main\n\nmain()\n'),
    _WORLD: ('world', 'from mujoco_world.node import main\n\nraise SystemExit(main())\n'),
}
SERVICES = (
    '/set_station',
    '/go_to_station/_action/send_goal',
    '/go_to_station/_action/cancel_goal',
    '/go_to_station/_action/get_result',
)
TOPICS = '/odom', '/cmd_vel'
MOST = 4  # programs that are started; two are asked for
SETTLED = 5.0  # s of wall time in which what else runs may end
RUNNING = 3  # programs that run in the launch: world, its publisher of frames, and robot
SHARE = 'install/delivery_robot/share/delivery_robot'
# A copy of the launch file is launched, in another folder, beside the parameter file as it was. The sources are away,
# and in the installed parameter file stand other values: so it shows which file the robot gets, and whether by the name
# of the package.
_PREPARE = f"""
    mv src sources; mkdir -p elsewhere/launch elsewhere/config
    cp {SHARE}/launch/delivery.launch.py elsewhere/launch; cp {SHARE}/config/delivery.yaml elsewhere/config
    printf '%s' "$1" > {SHARE}/config/delivery.yaml
    shift; unset COLCON_PREFIX_PATH; cd elsewhere; exec "$@"
"""
_RESTORE = f'mv sources src; cp elsewhere/config/delivery.yaml {SHARE}/config'


class Missing(Exception):
    """What did not come."""


class Programs:
    """Robot and world, as the launch file starts them: they run where it has not run."""

    def __init__(self, learner, modules: dict[str, str]):
        """:param modules: of the package with the robot, path → text."""
        self._learner, self._modules = learner, modules
        self._heard = stand_ins.of(learner)
        self._heard.release()
        self._tasks: list[tuple[str, Task]] = []
        self._robots: list[Start] = []  # how the launch file has started the robot
        # Where they answer for their parameters: no other node knows these names beforehand.
        self.asked = {node: f'/asked_{secrets.token_hex(6)}' for node in PROGRAMS}

    def go_on(self) -> None:
        """Start what the launch file has started meanwhile."""
        texts = dict(PROGRAMS.values())
        for start in self._heard.starts(*texts)[len(self._tasks) : MOST]:
            modules = {}
            if start.name == 'robot':
                modules = self._modules
                self._robots.append(start)
            node = next(node for node, (name, _) in PROGRAMS.items() if name == start.name)
            words = '--ros-args', '-r', f'{node}/get_parameters:={self.asked[node]}/get_parameters'
            self._tasks.append((start.name, start.begin(self._learner, texts[start.name], modules, words)))

    def started(self, node: str) -> bool:
        """Whether the program with this node was started."""
        return any(name == PROGRAMS[node][0] for name, _ in self._tasks)

    def died(self) -> bool:
        """Whether one has ended."""
        return any(task.wait(0) is not None for _, task in self._tasks)

    def besides(self, installed: str) -> dict:
        """The parameters that the launch file gave the robot besides the installed file, which has this text."""
        return parameter_files.given_besides(self._robots, installed, ('use_sim_time',))

    def end(self) -> str:
        """End them; what they have printed."""
        self._heard.release()
        for _, task in self._tasks:
            task.end()
        return '\n'.join(task.output for _, task in self._tasks)


class Customer:
    """Somebody who uses the robot."""

    def __init__(self, observer: Observer, launch, factor: float, programs: Programs):
        self.launch, self.programs, self.observer, self.node = launch, programs, observer, observer.node
        self.way = Way(self.node, factor)
        self._most: Counter[str] = Counter()  # who spoke at one moment
        self.stations = self.node.create_client(SetStation, 'set_station')
        self.action = ActionClient(self.node, GoToStation, 'go_to_station')
        self.status: list[str] = []  # what came on /status
        self.node.create_subscription(String, 'status', lambda message: self.status.append(message.data), 10)

    @property
    def x(self) -> float:
        return self.way.odometer

    def until(self, condition, what: str) -> None:
        def looked() -> object:
            self._look()
            return condition()

        deadline = time.monotonic() + PATIENCE * (3 if busy() else 1)
        while not self.observer.until(looked, 0.2, self.launch):
            if self.launch.wait(0) is not None:
                raise Missing('the end: ros2 launch has ended by itself')
            self.programs.go_on()
            if self.programs.died() or 'process has died' in self.launch.output:
                raise Missing(f'{what}: a process has died')
            if time.monotonic() > deadline:
                raise Missing(what)

    def answer(self, future, what: str):
        self.until(future.done, what)
        return future.result()

    def parameters(self, node: str) -> tuple[dict, bool]:
        """A node's values, and whether it is the program's own node which has said them."""
        self.until(lambda: node in self.observer.nodes(), f'the node {node}')
        own = self.programs.started(node)
        found = self.observer.parameters(self.programs.asked[node] if own else node, list(VALUES[node]), PATIENCE)
        if not found:
            raise Missing(f'the parameters of {node}')
        return found, own

    def _look(self) -> None:
        """Count who speaks in the place of robot or world just now, under whatever name."""
        for name in (*SERVICES, *(f'{asked}/get_parameters' for asked in self.programs.asked.values())):
            self._most[name] = max(self._most[name], self.node.count_services(name))
        for topic in TOPICS:
            self._most[topic] = max(self._most[topic], self.node.count_publishers(topic))

    def alone(self) -> bool:
        """Whether nobody else has ever spoken in the place of robot or world, also if they have left."""
        self._look()
        return all(count <= 1 for count in (*self._most.values(), *self.way.speakers.values()))

    def go(self, station: str):
        """Send a goal until it is accepted: the robot learns only now where it is."""
        accepted = []

        def tried():
            goal = self.answer(self.action.send_goal_async(GoToStation.Goal(station=station)), 'an answer to a goal')
            accepted[:] = [goal]
            return goal.accepted

        self.until(tried, f'an accepted goal: all goals to {station} were rejected')
        return accepted[0]

    def drive(self, station: str, call_back: bool = False) -> str:
        """Send the robot to a station, and perhaps call it back on its way; how the goal has ended.

        On a machine that is too busy, a right robot may be lost for a moment and give up: then it is sent again.
        """
        for _ in range(TRIES):
            goal, begin = self.go(station), self.x
            result = goal.get_result_async()
            if call_back:
                self.until(lambda: self.x > begin + 0.25 or result.done(), 'the robot on its way')  # noqa: B023
            if call_back and not result.done():
                self.answer(goal.cancel_goal_async(), 'an answer to the cancel request')
            status = STATUS.get(self.answer(result, f'the end of the goal {station}').status)
            if status != 'aborted':
                break
        return status

    def stands(self) -> bool:
        return abs(self.way.odometry.twist.twist.linear.x) < 0.02


def _story(customer: Customer, told: dict) -> None:
    """Set stations, drive, call the robot back, drive again."""
    told[_ROBOT], told['executable'] = customer.parameters(_ROBOT)
    values, own = customer.parameters(_WORLD)
    if not own:
        raise Missing('the world of mujoco_world')
    told[_WORLD] = values
    if not told[_ROBOT]['use_sim_time']:
        raise Missing(f'simulated time in {_ROBOT}')
    customer.until(customer.stations.service_is_ready, 'the service /set_station')
    customer.until(customer.action.server_is_ready, 'the action /go_to_station')
    for name, x in told['stations'].items():
        request = SetStation.Request(name=name, x=x)
        told[name] = customer.answer(customer.stations.call_async(request), 'an answer of /set_station').success
    far, near = told['stations']
    told['cancelled'] = customer.drive(far, call_back=True)
    customer.until(customer.stands, 'the robot standing after the cancel')
    told['stopped_at'] = round(customer.x, 3)
    told['arrived'] = customer.drive(near)
    customer.until(customer.stands, 'the robot standing at the station')
    driving = f'driving to {near}'
    customer.until(lambda: driving in customer.status, f'{driving!r} on /status')
    customer.until(lambda: customer.status[-1] == 'idle', "'idle' on /status, after the drive")
    told['ended_at'] = round(customer.x, 3)
    told['retraced'] = round(customer.way.retraced(), 3)
    told['nodes'] = customer.observer.nodes()
    customer.observer.until(lambda: customer.launch.programs <= RUNNING, SETTLED, customer.launch)
    told['programs'] = customer.launch.programs
    if not customer.alone():
        raise Missing('the end of what else speaks in the place of the robot or of the world')


def story(learner, workspace, modules: dict[str, str]) -> dict:
    """What happened: see above; `stations`, `factor` and `values` are what was drawn, `scene` is that of the world,
    `nodes` the nodes in the end, `programs` how many programs ran in the launch, `left` how many still did when it had
    ended, `log` what it has printed. `values` stood in the installed parameter file.

    :param modules: of the package, path → text.
    """
    draw = learner.random
    number = draw.randint(10, 99)
    told = {
        'stations': {f'far{number}': 6.0, f'near{number}': round(draw.uniform(0.9, 1.4), 2)},
        'values': {name: round(draw.uniform(low, high), 3) for name, (low, high) in DRAWN.items()},
        'factor': round(draw.choice(FACTORS) * (SLOWER if busy() else 1), 3),
        # The world takes a file, too: a launch file that allows two names only does not pass it on.
        'scene': str(Path(get_package_share_directory('mujoco_world'), 'scenes', 'empty.yaml')),
    }
    programs = Programs(learner, modules)
    installed = parameter_files.with_values(learner.text('DELIVERY_YAML'), told['values'])
    launch = workspace.start(
        'bash',
        '-c',
        _PREPARE,
        'bash',
        installed,
        *hurried_launch.COMMAND,
        'launch/delivery.launch.py',
        f'scene:={told["scene"]}',
        f'real_time_factor:={told["factor"]}',
    )
    with Observer(learner) as observer:
        try:
            _story(Customer(observer, launch, told['factor'], programs), told)
        except Missing as missing:
            told['missing'], told['nodes'] = str(missing), observer.nodes()
        told['besides'] = programs.besides(installed)
        launch.signal(signal.SIGINT)
        told['status'] = launch.wait(15.0 * (3 if busy() else 1))
        observer.until(lambda: not launch.programs, SETTLED)
        told['left'] = launch.programs
    launch.end()
    told['processes'] = processes(launch.output)
    told['log'] = f'{launch.output}\n{programs.end()}'
    workspace.run('bash', '-c', _RESTORE)
    return told
