"""Tests of exercise 8.9 with two goals of one moment, and with two robots in one program."""

from delivery_interfaces.action import GoToStation
from delivery_interfaces.srv import SetStation
from std_msgs.msg import String

from helpers.checks.chapter_05.two_goals import send_two
from helpers.checks.chapter_08.held_robot import AWAY, GATE, Held
from helpers.runner import about, expect

LEAST_PLACES, MOST_PLACES = 6, 40  # in the learner's lines, to which a thread comes until both goals are answered
ROUNDS = 5  # of 0.1 s, in which a goal has ended when the robot is at the station
THERE = GATE[0] - 0.2, 0.0  # x in metres, yaw in radians


def judge_two_goals(learner) -> None:
    """The rules `single` and `next`: two goals come, and a goal callback stands aside at one place after the other.

    Each time the robot is then put to the station, so that the next two can come soon. That a goal which is alone ends
    there is looked at before: it is the rule `succeeds`.
    """
    with about('single'):
        held = Held(learner, switches=True)
    held.stand(*AWAY, 0.1)
    _judge_end(held, held.go('next'), 'A goal came', 'succeeds')
    for place in range(1, MOST_PLACES):
        held.stand(*AWAY, 0.1)
        with about('single'):
            accepted, answered, stood = send_two(learner, held.node, held.client, place, station='gate')
        expect(
            accepted,
            f'{place - 1} goals have ended, two came after that, and both were rejected. The station is known, and no '
            'other goal runs.',
            'next',
        )
        expect(
            len(accepted) == 1,
            f'Two goals came at one moment, and both were accepted: the second one came while the goal callback of the '
            f'first stood before {stood}. Where two of them may run side by side, a lock must hold from the look at '
            "self.state until it is set. In the node's own callback group one runs after the other.",
            'single',
        )
        _judge_end(held, accepted[0], 'Two goals came at one moment, and one was accepted', 'single')
        if answered and place >= LEAST_PLACES:
            break


def _judge_end(held: Held, goal, told: str, rule: str) -> None:
    """The robot comes to the station: the goal ends."""
    for _ in range(ROUNDS):
        if goal.done:
            break
        held.stand(*THERE, 0.1)
    expect(
        goal.status == 'succeeded',
        f'{told}. Then the robot was at the station, and {ROUNDS / 10:g} s later the goal is '
        f'{goal.status or "still running"}, expected succeeded.{goal.why_aborted}',
        rule,
    )


def judge_two_robots(learner) -> None:
    """The rules `state` and `single`: what one robot does is nothing to another one in the same program.

    The one in a namespace drives first: so a server without a relative name is told as what it is.
    """
    with about('state'):
        held = Held(learner)
    name = f'/robot{learner.random.randint(2, 99)}'
    heard = learner.listen('/status', String)
    stations = learner.client(f'{name}/set_station', SetStation)
    client = learner.action_client(f'{name}/go_to_station', GoToStation)
    with about('state'):
        learner.start('DeliveryRobot', beside=held.node, threads=True, cli_args=['--ros-args', '-r', f'__ns:={name}'])
    held.stand(*AWAY, 0.1)
    stations.call(name='gate', x=GATE[0], y=GATE[1])
    with about('action'):
        goal = client.send(station='gate')
        learner.settle()
    expect(
        goal.accepted, f'The goal gate of {name} was rejected. The station is known, and no other goal runs.', 'next'
    )
    held.stand(*AWAY, 0.7)
    said = heard.data[-1] if heard.data else 'nothing'
    words = 'Two robots are in one program, and one of them drives. '
    own = 'Keep the state of a robot in the object (self), and nowhere in its class.'
    expect(said == 'idle', f"{words}The status of the other one is {said!r}, expected 'idle'. {own}", 'state')
    with about('single'):
        other = held.send()
        learner.settle()
    expect(other.accepted, f'{words}The other one rejects its goal, and no other goal of its own runs. {own}', 'single')
    held.stand(*AWAY, 0.3)
    expect(
        not goal.done and not other.done,
        f'{words}The other one got a goal, too. 0.3 s later the goals are {goal.status or "still running"} and '
        f'{other.status or "still running"}. The station is far. {own}',
        'single',
    )
