"""Launches the package delivery_robot and uses it as people would, over ROS, from the tests' side: what happened.

Only the package runs where the learner's code runs. Each step waits for a condition, with a bound; a step that fails
ends the story with the name of what was missing. Places and pace are drawn: a story that is told in advance is another.
"""

import signal
import time

from action_msgs.msg import GoalStatus
from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation
from rclpy.action import ActionClient

from helpers.runner.load import busy
from helpers.runner.observer import Observer
from helpers.runner.retracing import Way

PATIENCE = 25.0  # s of wall time for a step
TRIES = 5
FACTORS = 0.7, 0.75, 0.8, 0.85  # simulated seconds in a second: slower than real time leaves the programs more of it
SLOWER = 0.4  # times these on a busy machine: a right robot is lost if it hears nothing for half a simulated second
STATUS = {
    GoalStatus.STATUS_SUCCEEDED: 'succeeded',
    GoalStatus.STATUS_CANCELED: 'canceled',
    GoalStatus.STATUS_ABORTED: 'aborted',
}
_ROBOT, _STRING = '/delivery_robot', 'std_msgs/msg/String'
VALUES = {
    _ROBOT: ('max_linear', 'max_angular', 'tolerance', 'timeout', 'status_period', 'use_sim_time'),
    '/world': ('scene', 'real_time_factor'),
}


class Missing(Exception):
    """What did not come."""


class Customer:
    """Somebody who uses the robot."""

    def __init__(self, observer: Observer, launch, factor: float, only: str):
        """:param only: the topic on which only the executable of the package publishes."""
        self.launch, self.only, self.observer, self.node = launch, only, observer, observer.node
        self.way = Way(self.node, factor)
        self.stations = self.node.create_client(SetStation, 'set_station')
        self.action = ActionClient(self.node, GoToStation, 'go_to_station')

    @property
    def x(self) -> float:
        return self.way.odometer

    def until(self, condition, what: str) -> None:
        deadline = time.monotonic() + PATIENCE * (3 if busy() else 1)
        while not self.observer.until(condition, 0.2, self.launch):
            if self.launch.wait(0) is not None:
                raise Missing('the end: ros2 launch has ended by itself')
            if 'process has died' in self.launch.output:
                raise Missing(f'{what}: a process has died')
            if time.monotonic() > deadline:
                raise Missing(what)

    def answer(self, future, what: str):
        self.until(future.done, what)
        return future.result()

    def parameters(self, node: str) -> dict:
        self.until(lambda: node in self.observer.nodes(), f'the node {node}')
        found = self.observer.parameters(node, list(VALUES[node]), PATIENCE)
        if not found:
            raise Missing(f'the parameters of {node}')
        return found

    def look_for_executable(self) -> None:
        """Wait until the node shows what only the executable of the package shows."""
        self.until(
            lambda: f'/{self.only}' in self.observer.topics(_ROBOT, 'publisher', _STRING),
            'the executable of the package',
        )

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
    for node in VALUES:
        told[node] = customer.parameters(node)
    try:
        customer.look_for_executable()
    except Missing:
        told['executable'] = _ROBOT not in customer.observer.nodes()
        raise
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
    told['ended_at'] = round(customer.x, 3)
    told['retraced'] = round(customer.way.retraced(), 3)


def story(learner, workspace, only: str) -> dict:
    """What happened: see above; `stations` and `factor` are what was drawn, `log` what the launch has printed.

    :param only: the topic on which only the executable of the package publishes.
    """
    number = learner.random.randint(10, 99)
    told = {
        'stations': {f'far{number}': 6.0, f'near{number}': round(learner.random.uniform(0.9, 1.4), 2)},
        'factor': round(learner.random.choice(FACTORS) * (SLOWER if busy() else 1), 3),
    }
    launch = workspace.start(
        'bash',
        '-c',
        'mv src sources; exec "$@"',
        'bash',
        'ros2',
        'launch',
        'delivery_robot',
        'delivery.launch.py',
        'scene:=empty',
        f'real_time_factor:={told["factor"]}',
    )
    with Observer(learner) as observer:
        try:
            _story(Customer(observer, launch, told['factor'], only), told)
        except Missing as missing:
            told['missing'] = str(missing)
    launch.signal(signal.SIGINT)
    told['status'] = launch.wait(15.0 * (3 if busy() else 1))
    launch.end()
    told['log'] = launch.output
    workspace.run('mv', 'sources', 'src')
    return told
