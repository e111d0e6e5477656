"""Tests of exercise 8.9 with a robot that is held: whatever it is told, it stands where the test says it is."""

import math

import pytest
from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation
from geometry_msgs.msg import Twist

from helpers.checks.chapter_05.driving import longest_pause
from helpers.checks.chapter_08.deliveries import Localizer
from helpers.checks.chapter_08.parameter_services import Parameters
from helpers.runner import about, expect
from helpers.runner.peers import SECOND

TOLERANCE, TIMEOUT, FASTEST, TURN = 0.5, 3.0, 0.5, 2.0  # the parameters of the node: m, s, m/s, rad/s
GATE = 0.5, 0.0  # the station, in metres
AWAY = GATE[0] - 1.5, 0.0  # a place that is far from it: x in metres, yaw in radians
FURTHER = AWAY[0] - 0.5  # x in metres
BESIDE = 0.106  # metres in y, where it is near: then the straight way, in hundredths of a metre, is another number
ASIDE = 1.105  # metres in y: the straight way from there is neither the one in x nor the one in y, nor both together


class Held:
    """The learner's node, which is told a place, and the station gate."""

    def __init__(self, learner, **options):
        """:param options: of `learner.start`."""
        self.learner, self._place = learner, Localizer(learner)
        self.client = learner.action_client('/go_to_station', GoToStation)
        stations = learner.client('/set_station', SetStation)
        self.commands = learner.listen('/cmd_vel', Twist)
        self.node = learner.start(
            'DeliveryRobot',
            threads=True,
            **options,
            parameters={'tolerance': TOLERANCE, 'timeout': TIMEOUT, 'max_linear': FASTEST, 'max_angular': TURN},
        )
        self.stand(0.0, 0.0)
        stations.call(name='gate', x=GATE[0], y=GATE[1])

    def go(self, rule: str):
        """Send the goal gate, which must be accepted."""
        with about(rule):
            goal = self.send()
            self.learner.settle()
        expect(goal.accepted, 'The goal gate was rejected. The station is known, and no other goal runs.', 'next')
        return goal

    def send(self):
        """Send the goal gate."""
        return self.client.send(station='gate')

    def stand(self, x: float, yaw: float, seconds: float = 0.5, y: float = 0.0) -> None:
        """The robot stands there (metres, radians) for so long, in steps of 0.1 s."""
        for _ in range(round(10 * seconds)):
            self._place.tell(x, y, yaw)
            self.learner.run(0.1)


def judge_held(learner, seconds: float) -> None:
    """The rules `rhythm`, `timeout`, `succeeds`, `result`, `stands`, `lost` and `feedback`.

    :param seconds: so long one of the drives takes.
    """
    with about('succeeds'):
        held = Held(learner)
    goal = held.go('rhythm')
    _judge_commands(held, goal)
    _judge_timeout(held, goal)
    _judge_border(held, goal.result.message)
    _judge_there_already(held)
    _judge_short_loss(held)
    _judge_lost_at_once(held)
    _judge_long_drive(held, seconds)


def _judge_commands(held: Held, goal) -> None:
    """The rule `rhythm`: the robot drives with what steer says to the answer of where."""
    draw = held.learner.random
    for low, high in ((0.12, 0.4), (0.6, 0.9)):  # it drives while it turns; it turns on the spot
        angle = draw.choice([-1, 1]) * round(draw.uniform(low, high), 3)
        x, y = -round(draw.uniform(0.4, 0.9), 3), round(draw.uniform(-0.3, 0.3), 3)
        yaw = math.atan2(GATE[1] - y, GATE[0] - x) - angle
        held.commands.clear()
        held.stand(x, yaw, 0.4, y)
        expect(
            not goal.done, f'A goal was accepted, and 0.4 s later it is {goal.status}. The station is far.', 'succeeds'
        )
        last = held.commands.messages[-1:] or [Twist()]
        got = last[0].linear.x, last[0].angular.z
        wanted = FASTEST if high < 0.5 else 0.0, 2 * angle
        expect(
            got == pytest.approx(wanted, abs=1e-3),
            f'The robot is at ({x:g}, {y:g}) and looks to {yaw:.3f} rad, the gate is at {GATE}, max_linear is '
            f'{FASTEST:g} and max_angular {TURN:g}. The command is linear.x {got[0]:.3f}, angular.z {got[1]:.3f}; '
            f'steer says {wanted[0]:g} and {wanted[1]:.3f}. Give steer the answer of where(), and drive with the '
            'result, as they are.',
            'rhythm',
        )


def _judge_timeout(held: Held, goal) -> None:
    """The rule `timeout`, of a robot that turns at last."""
    held.stand(-0.5, 2.0, TIMEOUT - 0.5)
    expect(
        goal.done and goal.status == 'aborted',
        f'With timeout = {TIMEOUT:g}, {TIMEOUT + 0.3:g} s after its start the goal is '
        f'{goal.status or "still running"}. For the last {TIMEOUT - 0.5:g} s the robot has turned on the spot. The '
        'time counts from the start of the goal, whatever the robot does.',
        'timeout',
    )


def _judge_border(held: Held, late: str) -> None:
    """The rules `succeeds` and `result`, of a robot that is as far away as the tolerance, and then a bit nearer.

    :param late: the message of a goal to the same station that took too long.
    """
    held.stand(0.0, 0.0)
    goal = held.go('next')
    held.stand(0.0, 0.0)
    expect(
        not goal.done or goal.status != 'succeeded',
        f'The tolerance is {TOLERANCE:g} m, the robot is exactly that far away from the station, and the goal has '
        'succeeded. It succeeds when the distance is below the tolerance.',
        'succeeds',
    )
    aside = 0.8 * TOLERANCE  # in x and in y: each is less than the tolerance, the straight way is more
    held.stand(GATE[0] - aside, 0.0, 0.3, GATE[1] + aside)
    expect(
        not goal.done or goal.status != 'succeeded',
        f'The tolerance is {TOLERANCE:g} m, the station is {aside:g} m away in x and as much in y, that is '
        f'{math.hypot(aside, aside):.2f} m, and the goal has succeeded. What counts is the distance of steer.',
        'succeeds',
    )
    held.stand(0.02, 2.5, 0.2, BESIDE)  # it looks away: that does not matter
    held.stand(*AWAY, 0.3)  # and it is carried away: then it is too late for whoever waits
    left = math.hypot(GATE[0] - 0.02, BESIDE)
    said = f', and says {goal.result.message!r}' if goal.done and goal.result.message else ''
    _judge_time_of_its_own(held, goal, late)
    expect(
        goal.status == 'succeeded',
        f'The tolerance is {TOLERANCE:g} m, and for 0.2 s the robot was {left:.3f} m away from the station; it looked '
        f'to 2.5 rad. The goal is {goal.status or "still running"}{said}. It succeeds in the round in which the '
        f'distance is below the tolerance.{goal.why_aborted}',
        'succeeds',
    )
    expect(
        goal.result.distance == pytest.approx(left, abs=1e-3),
        f'The goal has succeeded {left:.3f} m away from the station, {BESIDE:g} m of it in y, and the distance in its '
        f'result is {goal.result.distance:.3f}. It is the distance of steer, as it is.',
        'result',
    )
    expect(
        goal.result.message != late,
        f'A goal to the gate took too long, and another one has arrived there; both say {late!r}. The message says how '
        'the drive ended.',
        'result',
    )


def _judge_time_of_its_own(held: Held, goal, late: str) -> None:
    """The rule `timeout`, of a goal that came after one that took too long, and said so: `late`."""
    took = held.learner.now / SECOND - goal.sent
    expect(
        not (goal.status == 'aborted' and goal.result.message == late and took < TIMEOUT),
        f'A goal took too long, and said {late!r}. The next one is aborted {took:.1f} s after it was sent, and says '
        f'the same. With timeout = {TIMEOUT:g}, each goal has that time for itself.',
        'timeout',
    )


def _judge_there_already(held: Held) -> None:
    """The rules `succeeds` and `stands`, of a goal to the station at which the robot is."""
    near = GATE[0] - TOLERANCE / 5
    held.stand(near, 0.3)
    held.commands.clear()
    goal = held.go('next')
    held.stand(near, 0.3)
    told = 'The robot was at the station when the goal came.'
    expect(
        goal.status == 'succeeded',
        f'{told} 0.5 s later the goal is {goal.status or "still running"}, expected succeeded.{goal.why_aborted}',
        'succeeds',
    )
    stops = [(one.linear.x, one.angular.z) for one in held.commands.messages].count((0.0, 0.0))
    expect(
        stops == 1,
        f'{told} It has succeeded, and drive(0.0, 0.0) was called {stops} times, expected once: before every end, also '
        'where the robot has not driven.',
        'stands',
    )


def _judge_lost_at_once(held: Held) -> None:
    """The rules `lost` and `stands`, of a robot that is lost before it has driven for its goal."""
    held.stand(*AWAY)
    held.learner.run(0.35, step=0.05)  # the place is 0.45 s old: for one moment more it is known
    held.commands.clear()
    goal = held.go('next')
    with about('lost'):
        held.learner.run(0.3)
    told = 'A goal was accepted, and 0.1 s later where() was None.'
    expect(goal.status == 'aborted', f'{told} The goal is {goal.status or "still running"}, expected aborted.', 'lost')
    last = [(one.linear.x, one.angular.z) for one in held.commands.messages][-1:]
    expect(last == [(0.0, 0.0)], f'{told} It was aborted without a drive(0.0, 0.0): before every end.', 'stands')


def _judge_short_loss(held: Held) -> None:
    """The rule `lost`, of a localiser that is silent for 0.7 s: so where() is None for 0.2 s."""
    held.stand(*AWAY)
    goal = held.go('next')
    held.stand(*AWAY, 0.3)
    held.learner.run(0.6)
    held.stand(*AWAY, 0.3)
    expect(
        goal.status == 'aborted',
        f'While a goal ran, the localiser was silent for 0.7 s: where() was None for 0.2 s. The goal is '
        f'{goal.status or "still running"}, expected aborted: it ends in the round in which where() is None.',
        'lost',
    )


def _judge_long_drive(held: Held, seconds: float) -> None:
    """The rules `timeout`, `feedback`, `succeeds` and `lost`, of a robot that needs long, with a small tolerance."""
    tolerance, timeout = 0.03, round(seconds + 5.0)
    Parameters(held.learner, '/delivery_robot').set(tolerance=tolerance, timeout=float(timeout))
    held.stand(*AWAY)
    goal = held.go('next')
    held.stand(*AWAY, seconds, ASIDE)
    told = f'The tolerance is {tolerance:g} m now and the timeout {timeout} s, and a drive has taken {seconds:.1f} s. '
    expect(not goal.done, f'{told}The goal is {goal.status}, expected to go on.', 'timeout')
    _judge_distance(goal.feedback[-1].distance if goal.feedback else None, 'The last feedback says', 'feedback')
    held.stand(FURTHER, 0.0, 1.0, ASIDE)
    _judge_distance(
        goal.feedback[-1].distance if goal.feedback else None,
        'Before, it was nearer; then it was carried away, and 1 s later the last feedback says',
        'feedback',
        FURTHER,
    )
    held.stand(GATE[0] - 1.4 * tolerance, 0.0, 2.0)
    last = [one.linear.x for one in held.commands.messages][-1:]
    expect(
        goal.done or not last or last[0] == pytest.approx(1.4 * tolerance, abs=1e-3),
        f'{told}The robot was {1.4 * tolerance:.3f} m away from the station and looked at it, so steer says '
        f'{1.4 * tolerance:.3f} m/s, and the command is linear.x {last and last[0]:g}. Drive with the result of steer, '
        'as it is.',
        'rhythm',
    )
    expect(
        not goal.done,
        f'{told}The robot was {1.4 * tolerance:.3f} m away from the station, and the goal is {goal.status}.',
        'succeeds',
    )
    pause = longest_pause(goal, held.learner.now / SECOND)
    expect(pause < 0.65, f'{told}For {pause:.1f} s no feedback came, expected 2 to 5 in each second.', 'feedback')
    held.stand(GATE[0] - 0.7 * tolerance, 0.0, 0.3)
    expect(
        goal.status == 'succeeded',
        f'{told}The robot is {0.7 * tolerance:.3f} m away from the station, and the goal is '
        f'{goal.status or "still running"}, expected succeeded.',
        'succeeds',
    )
    held.stand(*AWAY)
    goal = held.go('next')
    held.stand(*AWAY, seconds, ASIDE)
    held.learner.run(1.0)
    expect(
        goal.status == 'aborted',
        f'{told}Then another one ran for {seconds:.1f} s, and the localiser fell silent: 1 s later the goal is '
        f'{goal.status or "still running"}, expected aborted.',
        'lost',
    )
    _judge_distance(goal.result.distance, 'It got lost there, and the result says', 'result')


def _judge_distance(said: float | None, who: str, rule: str, x: float = AWAY[0]) -> None:
    """The distance that is told of a robot aside, at this x; None: nothing was told, which is another rule."""
    y = ASIDE
    straight = math.dist((x, y), GATE)
    expect(
        said is None or said == pytest.approx(straight, abs=1e-3),
        f'The robot stood at ({x:g}, {y:g}), and the gate is at {GATE}: {straight:.3f} m away. {who} {said} m. It is '
        'the distance of steer.',
        rule,
    )
