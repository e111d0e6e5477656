"""Hidden tests of exercise 8.9, go to a station."""

import math

import pytest
from std_msgs.msg import String

from helpers.checks.chapter_08.deliveries import Delivery
from helpers.checks.chapter_08.parameters import Parameters
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.9')


def ended(goal, status: str, what: str) -> None:
    """Fail unless a goal was accepted and has ended so."""
    expect(goal.accepted, f'{what}: the goal was rejected.')
    expect(goal.status == status, f'{what}: the goal is {goal.status or "still running"}, expected {status}.')


@pytest.mark.weight(3)
def test_arrives(learner):
    """The robot reaches stations in any direction, stands there, and says how near it is.

    Every 0.1 s: where(), steer(), drive(), always with the newest place.
    """
    draw = learner.random
    delivery = Delivery(learner, start=(0.0, 0.0, draw.uniform(-3, 3)))
    for name, length, angle in (('one', draw.uniform(0.7, 1.0), draw.uniform(-0.5, 0.5)),
                                ('two', draw.uniform(0.7, 1.0), math.pi + draw.uniform(-0.5, 0.5))):
        delivery.station(name, length * math.cos(angle), length * math.sin(angle))
        goal = delivery.go(name)
        delivery.run(15.0, goal)
        ended(goal, 'succeeded', f'After 15 s on the way to {name}')
        delivery.near(name, 0.13)
        expect(0 <= goal.result.distance < 0.1, f'The goal {name} succeeded with the distance '
                                                f'{goal.result.distance:.2f} m in its result, expected less than 0.1.')
        expect(goal.result.message, 'The message in the result is empty. It says how the drive ended.')
        delivery.stands(f'The goal {name} has succeeded')


@pytest.mark.weight(2)
def test_feedback(learner):
    """Feedback tells the distance, 2 to 5 times a second.

    Not in every round: feedback is for people.
    """
    delivery = Delivery(learner)
    delivery.station('far', 3.0, learner.random.uniform(-0.3, 0.3))
    goal = delivery.go('far')
    delivery.run(2.0)
    rate = len(goal.feedback) / 2.0
    expect(goal.feedback, 'No feedback came.')
    expect(1.9 <= rate <= 5.6, f'{rate:g} feedback messages came in a second, expected 2 to 5.')
    told, truth = goal.feedback[-1].distance, delivery.distance('far')
    expect(abs(told - truth) < 0.35, f'The last feedback says {told:.2f} m, and the robot is {truth:.2f} m away.')


@pytest.mark.weight(3)
def test_cancel(learner):
    """A cancelled goal ends within 0.2 s; the robot stands; the result has what is left; the next goal succeeds.

    Look at is_cancel_requested in each round. What every end needs stands behind the loop.
    """
    delivery = Delivery(learner)
    delivery.station('far', 3.0, 0.0)
    goal = delivery.go('far')
    delivery.run(learner.random.uniform(1.2, 1.8))
    cancel = goal.cancel()
    delivery.run(0.3)
    expect(cancel.answer == 'accepted', f'The cancel request was not accepted: {cancel.answer or "no answer came"}.')
    ended(goal, 'canceled', '0.3 s after the cancel request')
    delivery.stands('The goal was cancelled')
    left = delivery.distance('far')
    expect(goal.result.distance == pytest.approx(left, abs=0.3),
           f'The distance in the result is {goal.result.distance:.2f} m, and {left:.2f} m were left.')
    delivery.station('near', delivery.robot.pose.x + 0.3, 0.0)
    goal = delivery.go('near')
    expect(goal.accepted, 'After a cancelled goal, the next one was rejected. Is self.state idle again?')
    delivery.run(6.0, goal)
    ended(goal, 'succeeded', 'The goal after a cancelled one')


@pytest.mark.weight(2)
def test_rejects(learner):
    """Rejected: a station that is not known, and a second goal while one runs. The first one goes on.

    self.state says whether a goal runs. Set it in the goal callback: two goals may come at one moment.
    """
    delivery = Delivery(learner)
    delivery.station('far', 3.0, 0.0)
    delivery.station('near', 0.5, 0.0)
    expect(delivery.go('moon').accepted is False, 'The goal moon was accepted, and nobody has set this station.')
    first, second = delivery.client.send(station='near'), delivery.client.send(station='far')
    learner.settle()
    expect([first.accepted, second.accepted].count(True) == 1,
           f'Two goals came at one moment, and {[first.accepted, second.accepted].count(True)} were accepted, expected '
           'one. Set self.state in the goal callback.')
    first = first if first.accepted else second
    delivery.run(0.5)
    expect(delivery.go('far').accepted is False, 'While a goal ran, a second one was accepted.')
    delivery.run(12.0, first)
    ended(first, 'succeeded', 'While it ran, other goals were rejected')


@pytest.mark.weight(3)
def test_lost(learner):
    """When the localiser falls silent, the robot stands and the goal is aborted; when it speaks again, goals succeed.

    where() is None: drive(0.0, 0.0), abort(). A goal is rejected as long as where() is None.
    """
    delivery = Delivery(learner)
    delivery.station('far', 3.0, 0.0)
    goal = delivery.go('far')
    delivery.run(learner.random.uniform(0.8, 1.5))
    delivery.robot.localization = False
    delivery.run(0.9)
    expect(goal.done, 'The localiser has said nothing for 0.9 s, and the robot drives on. It does not know where it '
                      'is.')
    ended(goal, 'aborted', 'The robot was lost on its way')
    delivery.stands('The robot was lost')
    expect(delivery.go('far').accepted is False, 'The robot does not know where it is, and a goal was accepted.')
    delivery.robot.localization = True
    delivery.run(0.3)
    delivery.station('near', delivery.robot.pose.x + 0.3, 0.0)
    goal = delivery.go('near')
    delivery.run(6.0, goal)
    ended(goal, 'succeeded', 'The robot knows again where it is')


@pytest.mark.weight(2)
def test_timeout(learner):
    """A drive that takes longer than the parameter timeout is aborted, and the robot stands.

    Count the rounds, or look at the clock.
    """
    timeout = learner.random.choice([2.0, 3.0])
    delivery = Delivery(learner, parameters={'timeout': timeout})
    delivery.station('far', 3.9, 0.0)
    goal = delivery.go('far')
    delivery.run(timeout - 0.4)
    expect(goal.accepted and not goal.done, f'With a timeout of {timeout:g} s, the goal is '
                                            f'{goal.status or "rejected"} after {timeout - 0.4:g} s.')
    delivery.run(0.8)
    ended(goal, 'aborted', f'The timeout of {timeout:g} s is over')
    delivery.stands('The timeout is over')


@pytest.mark.weight(2)
def test_parameters(learner):
    """max_linear and tolerance count as they are now: a robot that drives can be made slower.

    Read a parameter when you need it.
    """
    delivery = Delivery(learner)
    parameters = Parameters(learner, '/delivery_robot')
    delivery.station('far', 2.0, 0.0)
    goal = delivery.go('far')
    delivery.run(1.0)
    slow = learner.random.choice([0.15, 0.2, 0.25])
    parameters.set(max_linear=slow)
    delivery.run(0.3)
    delivery.robot.commands.clear()
    delivery.run(0.5)
    fastest = max((command.linear.x for command in delivery.robot.commands.messages), default=0.0)
    expect(fastest == pytest.approx(slow), f'max_linear was set to {slow} on the way, and the robot is told to drive '
                                           f'with {fastest:.2f} m/s.')
    parameters.set(max_linear=0.5, tolerance=0.5)
    delivery.run(10.0, goal)
    ended(goal, 'succeeded', 'After 10 s')
    distance = delivery.distance('far')
    expect(0.3 < distance < 0.52, f'The tolerance was set to 0.5 m on the way, and the goal succeeded {distance:.2f} m '
                                  'from the station.')


@pytest.mark.weight(2)
def test_state(learner):
    """The status says where it drives, and idle after the end.

    self.state = 'driving to NAME' in the goal callback, 'idle' behind the loop.
    """
    heard = learner.listen('/status', String)
    delivery = Delivery(learner, parameters={'status_period': 0.1})
    name = learner.random.choice(['kitchen', 'office', 'lab'])
    delivery.station(name, 0.6, 0.0)
    goal = delivery.go(name)
    delivery.run(0.5)
    expect(heard.data[-1] == f'driving to {name}', f'While the robot drives to {name}, the status is '
                                                   f'{heard.data[-1]!r}, expected {f"driving to {name}"!r}.')
    delivery.run(6.0, goal)
    delivery.run(0.3)
    expect(heard.data[-1] == 'idle', f'The goal has ended, and the status is {heard.data[-1]!r}, expected idle.')
