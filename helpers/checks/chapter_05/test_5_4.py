"""Visible tests of exercise 5.4, drive to a place."""

import pytest
from turtle_interfaces.action import DriveTo

from helpers.runner import expect
from helpers.runner.turtlesim import TurtleSim

pytestmark = pytest.mark.exercise('5.4')


def test_arrive(learner):
    """The turtle drives from (5.5, 5.5) to (7, 6), stops there, and the goal succeeds.

    Call steer() every 0.1 s and publish its command; within 0.1 m publish a Twist of zeros and succeed.
    """
    client = learner.action_client('/drive_to', DriveTo)
    sim = TurtleSim(learner, 5.5, 5.5, 0.0)
    learner.start('Driver', threads=True)
    sim.run(0.2)
    goal = client.send(x=7.0, y=6.0)
    sim.run(5.0, until=lambda: goal.done)
    expect(goal.accepted, 'The goal (7, 6) was rejected.')
    expect(goal.status == 'succeeded', f'The goal ended as {goal.status}, expected succeeded within 5 s.')
    expect(sim.distance(7.0, 6.0) < 0.2, f'The turtle has ended {sim.distance(7.0, 6.0):.2f} m from the place.')
    last = sim.commands.messages[-1]
    expect((last.linear.x, last.angular.z) == (0.0, 0.0), 'The turtle is there, but the last command still drives: '
                                                          'publish a Twist of zeros.')
    expect(goal.feedback, 'No feedback came.')


def test_outside(learner):
    """A place outside of the field, such as (12, 5), is rejected.

    x and y must be from 0 to 11.
    """
    client = learner.action_client('/drive_to', DriveTo)
    sim = TurtleSim(learner, 5.5, 5.5, 0.0)
    learner.start('Driver', threads=True)
    sim.run(0.2)
    goal = client.send(x=12.0, y=5.0)
    learner.settle()
    expect(goal.accepted is False, 'The goal (12, 5) was accepted. No turtle can get there.')


def test_cancel(learner):
    """When the goal is cancelled, the turtle stops at once.

    Publish a Twist of zeros before canceled().
    """
    client = learner.action_client('/drive_to', DriveTo)
    sim = TurtleSim(learner, 1.0, 1.0, 0.0)
    learner.start('Driver', threads=True)
    sim.run(0.2)
    goal = client.send(x=10.0, y=1.0)
    sim.run(0.8)
    goal.cancel()
    sim.run(0.5)
    expect(goal.status == 'canceled', f'The cancelled goal ended as {goal.status}, expected canceled, within 0.5 s.')
    x = sim.turtle.x
    sim.run(0.5)
    expect(abs(sim.turtle.x - x) < 0.01, f'After the goal had ended, the turtle drove on for {sim.turtle.x - x:.2f} m. '
                                         'The simulator goes on for a second with the last command: publish zeros.')
