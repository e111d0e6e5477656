"""Hidden tests of exercise 5.4, drive to a place."""

import math

import pytest
from geometry_msgs.msg import Twist
from turtle_interfaces.action import DriveTo
from turtlesim.msg import Pose

from helpers.runner import expect
from helpers.runner.turtlesim import TurtleSim

pytestmark = pytest.mark.exercise('5.4')


def begin(learner, x=5.5, y=5.5, theta=0.0):
    client = learner.action_client('/drive_to', DriveTo)
    sim = TurtleSim(learner, x, y, theta)
    node = learner.start('Driver', threads=True)
    sim.run(0.2)
    return client, sim, node


def stands(sim) -> bool:
    """Whether the last command was one of zeros."""
    last = sim.commands.messages[-1]
    return (last.linear.x, last.angular.z) == (0.0, 0.0)


@pytest.mark.weight(3)
def test_arrive(learner):
    """The turtle arrives, within 0.1 m, from wherever it stands and looks, and stops there.

    Use steer() with the newest pose, not with the first one; at the end publish a Twist of zeros.
    """
    draw = learner.random
    client, sim, node = begin(learner, draw.uniform(4, 7), draw.uniform(4, 7), draw.uniform(-3, 3))
    expect(node.name == '/driver', f'Your node is called {node.name}, expected /driver.')
    for number in range(2):
        angle, length = draw.uniform(-3, 3), draw.uniform(0.8, 1.8)
        x, y = sim.turtle.x + length * math.cos(angle), sim.turtle.y + length * math.sin(angle)
        goal = client.send(x=x, y=y)
        sim.run(6.0, until=lambda: goal.done)  # noqa: B023 - used within the round
        expect(goal.accepted, f'Goal {number + 1}, ({x:.1f}, {y:.1f}), was rejected.')
        expect(goal.status == 'succeeded', f'The goal ({x:.1f}, {y:.1f}) ended as {goal.status}, expected succeeded '
                                           'within 6 s.')
        distance = sim.distance(x, y)
        expect(distance < 0.15, f'The goal succeeded when the turtle was {distance:.2f} m from the place, expected '
                                'less than 0.1 m.')
        expect(goal.result.distance == pytest.approx(distance, abs=0.1) and 0 < goal.result.distance < 0.1,
               f'The distance in the result is {goal.result.distance:.3f} m; the turtle was {distance:.3f} m away.')
        expect(stands(sim), 'The goal succeeded, but the last command still drives. Publish a Twist of zeros.')


@pytest.mark.weight(2)
def test_feedback(learner):
    """Feedback tells the distance, 2 to 5 times a second, while the turtle drives.

    Not in every round of a fast loop: feedback is for people and for slow decisions.
    """
    client, sim, _ = begin(learner, 1.0, 1.0)
    goal = client.send(x=10.0, y=learner.random.uniform(1, 3))
    truth = []
    for _ in range(5):
        sim.run(0.4)
        truth.append(sim.distance(goal.request.x, goal.request.y))
    rate = len(goal.feedback) / 2.0
    expect(goal.feedback, 'No feedback came.')
    expect(rate <= 5.6, f'{rate:g} feedback messages came in a second, expected at most 5: do not flood.')
    expect(rate >= 1.9, f'{rate:g} feedback messages came in a second, expected at least 2.')
    told = [feedback.distance for feedback in goal.feedback]
    expect(told == sorted(told, reverse=True), 'The turtle comes nearer, but the distance in the feedback does '
                                               'not fall.')
    expect(abs(told[-1] - truth[-1]) < 0.7, f'The last feedback says {told[-1]:.2f} m, and the turtle is '
                                            f'{truth[-1]:.2f} m away: use the newest pose.')


@pytest.mark.weight(2)
def test_cancel(learner):
    """A cancelled goal ends within 0.2 s; the turtle stops and stays; the result has the distance that is left.

    Look at is_cancel_requested in each round; publish zeros before canceled().
    """
    client, sim, _ = begin(learner, 1.0, 1.0)
    goal = client.send(x=10.0, y=1.0)
    sim.run(learner.random.uniform(0.6, 1.6))
    cancel = goal.cancel()
    sim.run(0.3)
    expect(cancel.done, 'The cancel request was not answered while the turtle drove: no thread was free to hear it.')
    expect(cancel.answer == 'accepted', 'The cancel request was refused.')
    expect(goal.status == 'canceled', f'0.3 s after the cancel request the goal is {goal.status or "still running"}, '
                                      'expected canceled.')
    expect(stands(sim), 'After the goal was cancelled, the last command still drives. Publish a Twist of zeros.')
    left = sim.distance(10.0, 1.0)
    expect(goal.result.distance == pytest.approx(left, abs=0.6),
           f'The distance in the result is {goal.result.distance:.2f} m, and {left:.2f} m were left.')
    count = len(sim.commands)
    sim.run(0.3)
    expect(len(sim.commands) == count, 'Commands came after the goal had ended.')
    again = client.send(x=sim.turtle.x, y=1.5)
    sim.run(4.0, until=lambda: again.done)
    expect(again.status == 'succeeded', f'After a cancelled goal, the next one ended as {again.status or "rejected"}.')


def test_outside(learner):
    """Places outside of 0 … 11 are rejected; the corners are not.

    Both x and y, on both sides.
    """
    client, _, _ = begin(learner)
    for x, y in ((-0.1, 5.0), (5.0, -learner.random.uniform(0.1, 9)), (11.2, 5.0), (5.0, 11.1)):
        goal = client.send(x=x, y=y)
        learner.settle()
        expect(goal.accepted is False, f'The goal ({x:g}, {y:g}) was accepted.')
    goal = client.send(x=11.0, y=0.0)
    learner.settle()
    expect(goal.accepted, 'The goal (11, 0) was rejected: it is a corner of the field. Do goals that were rejected '
                          'leave something behind?')


def test_one_at_a_time(learner):
    """While one goal runs, others are rejected, and the turtle goes on to the first place.

    Two goals must not fight for one motor. Note in the goal callback that the robot is taken.
    """
    client, sim, _ = begin(learner)
    other = learner.action_client('/drive_to', DriveTo)
    first, second = client.send(x=7.0, y=5.5), other.send(x=1.0, y=1.0)
    sim.run(0.5)
    third = other.send(x=2.0, y=9.0)
    sim.run(5.0, until=lambda: first.done)
    expect([first.accepted, second.accepted, third.accepted] == [True, False, False],
           'Two goals came at one moment, and one more while the turtle drove; '
           f'{[first.accepted, second.accepted, third.accepted].count(True)} were accepted, expected the first only.')
    expect(first.status == 'succeeded', f'The first goal ended as {first.status}, expected succeeded.')


def test_stuck(learner):
    """A turtle that does not get there is given up after 20 s: zeros, and aborted.

    Count the rounds, or look at the clock. A goal must end.
    """
    client = learner.action_client('/drive_to', DriveTo)
    poses = learner.talk('/turtle1/pose', Pose)
    commands = learner.listen('/turtle1/cmd_vel', Twist)
    learner.start('Driver', threads=True)
    poses.send(Pose(x=2.0, y=2.0))
    learner.settle()
    goal = client.send(x=9.0, y=2.0)
    learner.run(18.0)
    expect(goal.accepted, 'The goal was rejected.')
    expect(not goal.done, f'The goal ended as {goal.status} after {goal.finished or 0:g} s, expected to be given up '
                          'after 20 s.')
    learner.run(4.0)
    expect(goal.done, 'The turtle did not move for 22 s, and the goal still runs.')
    expect(goal.status == 'aborted', f'The turtle never came near; the goal ended as {goal.status}, expected aborted.')
    expect(goal.finished - goal.sent == pytest.approx(20.0, abs=0.5),
           f'The goal was given up after {goal.finished - goal.sent:g} s, expected 20 s.')
    last = commands.messages[-1]
    expect((last.linear.x, last.angular.z) == (0.0, 0.0), 'The goal was given up, but the last command still drives: '
                                                          'publish a Twist of zeros.')


