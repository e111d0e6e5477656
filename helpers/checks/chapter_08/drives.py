"""What the tests of exercise 8.9 share: drives of the learner's DeliveryRobot, and how they must go on and end."""

import math

import pytest
from delivery_interfaces.action import GoToStation
from std_msgs.msg import String

from helpers.checks.chapter_05.driving import check_order
from helpers.checks.chapter_08.deliveries import Delivery
from helpers.checks.chapter_08.parameter_services import Parameters
from helpers.runner import about, expect
from helpers.runner.peers import SECOND

OFFBEAT = 0.03  # s: goals begin and end between two messages on status, which come every 0.1 s
SAME = 1e-3  # s: what is said in the moment of a change may be the old or the new state
TURN, TOLERANCE = 1.0, 0.1  # the defaults of max_angular and tolerance


class Drives:
    """The learner's robot with its customers."""

    def __init__(self, learner, start: tuple[float, float, float] = (0.0, 0.0, 0.0), **parameters):
        """:param start: of the robot: x, y, yaw. :param parameters: of the node."""
        with about('rhythm'):
            self.heard = learner.listen('/status', String)
            self.delivery = Delivery(learner, parameters={'status_period': 0.1, **parameters}, start=start)
        self.learner, self.robot, self.commands = learner, self.delivery.robot, self.delivery.robot.commands
        self.parameters = Parameters(learner, '/delivery_robot')
        self.run, self.goal = self.delivery.run, None
        self.ends: dict[str, str] = {}  # what the results of goals that did not arrive said, and when
        self.run(OFFBEAT)

    def go(self, station: str, rule: str, why: str):
        """Send a goal that must be accepted; else `rule` is broken."""
        with about(rule):
            goal = self.delivery.go(station)
        expect(goal.accepted, f'{why}: the goal {station} was rejected.', rule)
        return goal

    def rejected(self, station: str, rule: str, why: str) -> None:
        """Send a goal that must be rejected."""
        with about(rule):
            goal = self.delivery.go(station)
        expect(goal.accepted is False, f'The goal {station} was accepted. {why}', rule)

    def ahead(self, name: str, metres: float) -> None:
        """Set a station in front of the robot."""
        pose = self.robot.pose
        self.delivery.station(name, pose.x + metres * math.cos(pose.yaw), pose.y + metres * math.sin(pose.yaw))

    def status(self, wanted: str, when: str) -> None:
        """Fail unless this is what the robot says of itself."""
        self.run(0.25)
        said = self.heard.data[-1] if self.heard.data else 'nothing'
        expect(said == wanted, f'{when}, the status is {said!r}, expected {wanted!r}.', 'state')

    def set(self, **values) -> None:
        """Set parameters."""
        expect(self.parameters.set(**values).successful, f'{values} was refused. Look at exercise 8.7.', 'limits')

    def recent(self, seconds: float) -> list:
        """The commands of this time."""
        self.commands.clear()
        self.run(seconds)
        return self.commands.messages

    def state(self, wanted: str, when: str) -> None:
        """Fail unless this is the state of the robot now."""
        found = self.delivery.node.call('__getattribute__', 'state')
        expect(found == wanted, f'{when}: self.state is {found!r}, expected {wanted!r} at this moment.', 'state')

    def ended(self, goal, status: str, rule: str, when: str) -> None:
        """Fail unless the goal has ended so, and the robot stands, and says so."""
        is_now = goal.status or 'still running'
        expect(goal.status == status, f'{when} the goal is {is_now}, expected {status}.{goal.why_aborted}', rule)
        sent = [(command.linear.x, command.angular.z) for command in self.commands.messages]
        expect(
            sent and sent[-1] == (0.0, 0.0),
            f'{when} the goal was {status}, and the last command is '
            f'{sent and sent[-1]}. Before every end: drive(0.0, 0.0).',
            'stands',
        )
        expect(
            len(sent) < 2 or sent[-2] != (0.0, 0.0),
            f'{when} the goal was {status}, and the robot was told more than once to stand. Once is enough.',
            'stands',
        )
        check_order(self.commands, goal, f'{when} the goal was {status}: ', 'stands')
        count = len(self.commands)
        self.run(0.4)
        expect(
            len(self.commands) == count,
            f'{when} the goal was {status}, and then {len(self.commands) - count} more commands came on cmd_vel.',
            'stands',
        )
        expect(
            goal.result.message.strip(),
            f'{when} the goal was {status}, and the message in its result is empty.',
            'result',
        )
        self._message(goal.result.message, status, when)
        said = zip(self.heard.data, self.heard.stamps, strict=True)
        late = [(text, at - goal.finished) for text, at in said if at > goal.finished + SAME and text != 'idle']
        text, after = late[0] if late else ('', 0.0)
        expect(
            not late,
            f"{when} the goal was {status}. {after:.2f} s after its end the status was {text!r}, expected 'idle': the "
            'state changes when the goal ends.',
            'state',
        )
        self.status('idle', f'{when} the goal was {status}. After that')

    def _message(self, message: str, status: str, when: str) -> None:
        """Fail if a goal that arrived says the same as one before it that did not."""
        if status != 'succeeded':
            self.ends[message] = f'{when} another goal was {status}'
        expect(
            status != 'succeeded' or message not in self.ends,
            f'A goal has arrived, and its message is {message!r}. {self.ends.get(message)}, with the same message. '
            'It says how the drive ended.',
            'result',
        )


def judge_name(learner) -> None:
    """The rule `action`: its name is relative."""
    namespace = f'/robot{learner.random.randint(2, 99)}'
    client = learner.action_client(f'{namespace}/go_to_station', GoToStation)
    with about('action'):
        learner.start('DeliveryRobot', threads=True, remap={'__ns': namespace})
        learner.settle()
        goal = client.send(station='nowhere')
        learner.settle()
    expect(
        goal.accepted is False,
        f'In the namespace {namespace}, a goal was sent to {namespace}/go_to_station: a station that nobody has set. '
        'It was not rejected. A relative name has no slash at its beginning.',
        'action',
    )


def judge_rejections(drives: Drives) -> str:
    """The rules `rejects-unknown`, `single` and `state`. Returns the name of the station to which the robot drives."""
    name = drives.learner.random.choice(['Kitchen 2', 'Office B', 'The lab'])
    name += f', at the end of the corridor on the {drives.learner.random.randint(2, 9)}. floor'  # letter by letter
    drives.delivery.station(name, 3.5, 0.0)
    # On another side: who drives there in place of the goal turns as fast, and only the way tells it.
    drives.delivery.station('other', 0.8, -math.copysign(1.0, drives.robot.pose.yaw))
    for unknown in ('moon', name[:-1], name.upper()):
        drives.rejected(unknown, 'rejects-unknown', 'Nobody has set this station.')
    with about('single'):
        both = [drives.delivery.client.send(station=name) for _ in range(2)]
        drives.learner.settle()
    accepted = [goal for goal in both if goal.accepted]
    expect(
        accepted,
        f'The goal {name} was rejected. The station is known, the place of the robot is, and no other goal runs.',
        'next',
    )
    expect(
        len(accepted) == 1,
        'Two goals came at one moment, and both were accepted. Set self.state in the goal '
        'callback: execute comes too late.',
        'single',
    )
    (drives.goal,) = accepted
    drives.state(f'driving to {name}', f'The goal {name} was accepted, and no time has passed')
    drives.status(f'driving to {name}', f'While the robot drives to {name}')
    drives.commands.clear()
    for station in ('moon', 'other'):  # whatever the reason: the first goal goes on
        drives.rejected(station, 'single', f'The robot is still driving to {name}.')
    drives.run(0.2)
    expect(
        all((command.linear.x, command.angular.z) != (0.0, 0.0) for command in drives.commands.messages),
        f'While the robot drove to {name}, other goals were rejected, and it was told to stand: drive(0.0, 0.0). The '
        'first goal goes on as if nothing had come.',
        'single',
    )
    expect(
        not drives.goal.done,
        f'While the robot drove to {name}, another goal was rejected, and the first one is '
        f'{drives.goal.status} now. It goes on.',
        'single',
    )
    drives.status(f'driving to {name}', f'While the robot drove to {name}, another goal was rejected. After that')
    return name


def judge_turning(drives: Drives) -> None:
    """The rules `rhythm` and `limits`, of a robot that turns on the spot."""
    told = len(drives.goal.feedback)
    came = drives.recent(0.5)
    expect(
        came,
        'A goal runs, and for 0.5 s no command came on cmd_vel. Drive in each round, also if the command is the same.',
        'rhythm',
    )
    gaps = [late - early for early, late in zip(drives.commands.stamps, drives.commands.stamps[1:], strict=False)]
    expect(
        len(came) > 2 and gaps == pytest.approx([0.1] * len(gaps), abs=0.02),
        f'While a goal runs, these are the seconds from one command to the next: {[round(gap, 3) for gap in gaps]}, '
        'expected 0.1.',
        'rhythm',
    )
    turns = sorted({round(abs(command.angular.z), 3) for command in came})
    expect(
        turns == [TURN],
        f'The goal lies behind the robot, and angular.z of its commands is {turns}, expected {TURN} (max_angular).',
        'limits',
    )
    for limit in (drives.learner.random.choice([0.4, 0.6]), 1.8):
        drives.set(max_angular=limit)
        drives.run(0.15)
        came = drives.recent(0.15)
        got = abs(came[-1].angular.z) if came else 0.0
        expect(
            got == pytest.approx(limit),
            f'max_angular was set to {limit} on the way, and angular.z is still '
            f'{got:.2f}. Read the parameter in each round.',
            'limits',
        )
    expect(
        len(drives.goal.feedback) > told,
        'For 1 s the robot has turned on the spot, and no feedback came: it comes as long as the goal runs.',
        'feedback',
    )


def judge_driving(drives: Drives, name: str) -> None:
    """The rules `feedback` and `limits`, of a robot that drives straight ahead."""
    goal = drives.goal
    drives.run(3.0, goal)
    begin = len(goal.feedback)
    drives.run(2.0, goal)
    expect(
        drives.delivery.distance('other') > 0.4,
        f'The goal other was rejected, and yet the robot drives there, and not to {name}. Take the station from the '
        'goal that you execute.',
        'single',
    )
    expect(not goal.done, f'On the way to {name} the goal has ended: {goal.status}.', 'succeeds')
    rate = (len(goal.feedback) - begin) / 2.0
    expect(1.9 <= rate <= 5.6, f'{rate:g} feedback messages came in a second, expected 2 to 5.', 'feedback')
    told, truth = goal.feedback[-1].distance, drives.delivery.distance(name)
    expect(
        abs(told - truth) < 0.3,
        f'The last feedback says {told:.2f} m, and the robot is {truth:.2f} m away from {name}.',
        'feedback',
    )
    distances = [feedback.distance for feedback in goal.feedback]
    expect(
        any(abs(distance - round(distance, 1)) > 1e-4 for distance in distances),
        f'The feedback of a drive told the distances {distances[-4:]}: all of them are rounded. Tell the distance as '
        'steer gives it.',
        'feedback',
    )
    for limit in (drives.learner.random.choice([0.15, 0.2, 0.25]), drives.learner.random.choice([0.6, 0.7])):
        drives.set(max_linear=limit)
        drives.run(0.2)
        fastest = max((command.linear.x for command in drives.recent(0.3)), default=0.0)
        expect(
            fastest == pytest.approx(limit),
            f'max_linear was set to {limit} on the way, and linear.x of the commands '
            f'is {fastest:.2f}. Read the parameter in each round.',
            'limits',
        )
    drives.set(max_linear=0.5)
    drives.run(0.2)


def judge_cancel(drives: Drives, name: str) -> None:
    """The rules `cancel`, `stands`, `result`, `next` and `succeeds`: called back, and sent again."""
    goal, begin = drives.goal, drives.learner.now / SECOND
    with about('cancel'):
        request = goal.cancel()
        drives.learner.settle()
    if not goal.done:  # it goes on until the next round, and so does what holds while a goal runs
        drives.state(f'driving to {name}', f'A cancel request came, and the goal {name} has not ended')
        drives.rejected(name, 'single', 'The goal before it is called back, and has not ended.')
    with about('cancel'):
        drives.run(0.35)
    expect(
        request.answer == 'accepted',
        f'The cancel request was not accepted: {request.answer or "no answer came"}.',
        'cancel',
    )
    left = drives.delivery.distance(name)
    drives.ended(goal, 'canceled', 'cancel', '0.35 s after a cancel request')
    expect(
        goal.finished - begin < 0.25,
        f'The goal ended {goal.finished - begin:.2f} s after the cancel request, expected at most 0.2 s.',
        'cancel',
    )
    expect(
        goal.result.distance == pytest.approx(left, abs=0.2),
        f'Cancelled, the goal has the distance {goal.result.distance:.2f} m in its result, and {left:.2f} m were left.',
        'result',
    )
    drives.ahead('near', 0.6)
    again = drives.go('near', 'next', 'A goal was cancelled, and this is the next one')
    drives.run(8.0, again)
    judge_arrived(drives, again, 'near', TOLERANCE)
    _judge_quick_cancel(drives)


def _judge_quick_cancel(drives: Drives) -> None:
    """The rules `next`, after an arrival, and `cancel`, directly after the start of a goal."""
    drives.delivery.station('home', 0.0, 0.0)  # the origin of the map is a place like any other
    goal = drives.go('home', 'next', 'A goal has succeeded, and this is the next one, to the station at (0, 0)')
    _cancel_soon(drives, goal, '')
    drives.ahead('door', 0.28)
    _cancel_soon(drives, drives.go('door', 'next', 'A goal was cancelled, and this is the next one'), ' 0.28 m away')


def _cancel_soon(drives: Drives, goal, there: str) -> None:
    """The rule `cancel`, directly after the start of a goal that lies `there`."""
    drives.run(0.15)
    begin = drives.learner.now / SECOND
    with about('cancel'):
        goal.cancel()
        drives.run(0.7, goal)
    expect(
        goal.done and goal.finished - begin < 0.25,
        f'0.15 s after a goal{there} was sent it was cancelled, and '
        + (f'ended {goal.finished - begin:.2f} s after that' if goal.done else 'still runs 0.7 s after that')
        + ', expected at most 0.2 s.',
        'cancel',
    )


def _judge_each_round(drives: Drives, goal, name: str) -> None:
    """The rule `rhythm`: while the robot slows down before this station, each command is for another place."""
    sent = zip(drives.commands.messages, drives.commands.stamps, strict=True)
    slower = [round(one.linear.x, 4) for one, at in sent if at > goal.sent and 0.05 < one.linear.x < 0.45]
    same = sum(early == late for early, late in zip(slower, slower[1:], strict=False))
    expect(
        len(slower) < 8 or 5 * same <= 2 * len(slower),  # now and then a place may come a round later
        f'Before {name} the robot slows down, and these were the values of linear.x, from round to round: '
        f'{slower[:8]}. The place was another one in each round: ask where() and steer() every 0.1 s.',
        'rhythm',
    )


def _judge_one_each_round(drives: Drives, goal, name: str) -> None:
    """The rule `rhythm`: on the way, commands come one by one; those of the last round have another rule."""
    stamps = [at for at in drives.commands.stamps if at > goal.sent][:-2]
    least = min((late - early for early, late in zip(stamps, stamps[1:], strict=False)), default=0.1)
    expect(
        least > 0.05,
        f'On the way to {name} two commands came within {least:.3f} s. In each round, every 0.1 s, the robot gets one.',
        'rhythm',
    )


def _judge_state_to_the_end(drives: Drives, goal, name: str) -> None:
    """The rule `state`: from the first moment to the last the robot is on its way."""
    last = goal.finished - SAME if goal.done else math.inf
    said = zip(drives.heard.data, drives.heard.stamps, strict=True)
    wrong = [
        (text, at - goal.sent) for text, at in said if goal.sent + SAME < at < last and text != f'driving to {name}'
    ]
    text, after = wrong[0] if wrong else ('', 0.0)
    expect(
        not wrong,
        f'{after:.2f} s after the goal {name} was sent it ran, and the status was {text!r}, expected '
        f"'driving to {name}' from its beginning to its end.",
        'state',
    )


def judge_arrived(drives: Drives, goal, name: str, tolerance: float, *, new: bool = False) -> None:
    """The rules `succeeds`, with this tolerance, and `state`, to the end. `new`: it was set while the robot drove."""
    _judge_each_round(drives, goal, name)
    _judge_one_each_round(drives, goal, name)
    _judge_state_to_the_end(drives, goal, name)
    seconds = drives.learner.now / SECOND - goal.sent
    distance = drives.delivery.distance(name)
    is_now = goal.status or 'still running'
    expect(
        not new or goal.status == 'succeeded' or distance > tolerance,
        f'The tolerance was set to {tolerance:g} while the robot drove to {name}. It is {distance:.2f} m away from '
        f'there, and {seconds:.1f} s after it was sent the goal is {is_now}, expected succeeded: read the '
        'tolerance in each round.',
        'succeeds',
    )
    drives.ended(goal, 'succeeded', 'succeeds', f'{seconds:.1f} s after it was sent,')
    told = f'With tolerance = {tolerance:g}, the goal {name} succeeded'
    if new:
        told = f'The tolerance was set to {tolerance:g} while the robot drove, and the goal {name} succeeded'
    expect(distance < tolerance + 0.05, f'{told} {distance:.2f} m away from the station.', 'succeeds')
    expect(distance > tolerance - 0.15, f'{told} only {distance:.2f} m away from the station.', 'succeeds')
    last = goal.feedback[-1].distance if goal.feedback else 0.0  # whether there is any is judged elsewhere
    expect(
        last < 1.8 * tolerance + 0.1,
        f'{told}, and its last feedback told a distance of {last:.2f} m: it comes at least twice a second, to the end.',
        'feedback',
    )
    expect(
        0 <= goal.result.distance < tolerance,
        f'{told} with the distance {goal.result.distance:.2f} m in its result.',
        'result',
    )


def judge_lost(drives: Drives) -> None:
    """The rules `rejects-lost` and `lost`."""
    drives.delivery.station('far', 3.5, 0.0)
    drives.robot.localization = False
    drives.run(0.8)
    drives.rejected('far', 'rejects-lost', 'The robot does not know where it is.')
    drives.robot.localization = True
    drives.run(0.3)
    goal = drives.go('far', 'next', 'The robot knows again where it is')
    drives.run(drives.learner.random.uniform(0.8, 1.2))
    drives.robot.localization = False
    left = drives.delivery.distance('far')
    drives.run(0.9)
    expect(
        goal.done,
        'The localiser has said nothing for 0.9 s, and the goal runs on. The robot does not know where '
        'it is: where() is None.',
        'lost',
    )
    drives.ended(goal, 'aborted', 'lost', 'Lost on its way,')
    expect(
        goal.result.distance == pytest.approx(left, abs=0.2),
        f'Lost on its way, the goal has the distance {goal.result.distance:.2f} m in its result. It was known last '
        f'about {left:.2f} m before the station.',
        'result',
    )
    drives.robot.localization = True
    drives.run(0.3)


def judge_timeout(drives: Drives, timeout: float) -> None:
    """The rules `timeout`, `next` and `succeeds`: a goal that takes too long, and the one after it."""
    goal = drives.go('far', 'next', 'A goal was aborted, and the robot knows again where it is')
    drives.run(timeout - 0.15)  # a drive that counts its rounds may end one round early
    expect(
        not goal.done,
        f'With timeout = {timeout:g}, the goal is {goal.status} after {timeout - 0.15:g} s. Each goal '
        'has that time for itself.',
        'timeout',
    )
    drives.run(0.55)
    expect(goal.done, f'With timeout = {timeout:g}, the goal still runs after {timeout + 0.4:g} s.', 'timeout')
    drives.ended(goal, 'aborted', 'timeout', f'The timeout of {timeout:g} s is over, and')
    tolerance = drives.learner.random.choice([0.35, 0.4, 0.45])
    drives.ahead('near', 0.9)
    again = drives.go('near', 'next', 'A goal has met its timeout, and this is the next one')
    drives.run(0.3)
    drives.set(tolerance=tolerance)
    drives.run(timeout - 0.3, again)
    judge_arrived(drives, again, 'near', tolerance, new=True)
