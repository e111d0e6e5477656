"""Visible tests of exercise 8.9, go to a station."""

import pytest

from helpers.checks.chapter_08.deliveries import Delivery
from helpers.runner import expect

pytestmark = pytest.mark.exercise('8.9')


def test_arrives(learner):
    """The robot drives to a station 1 m ahead and stands there, and the goal succeeds.

    Every 0.1 s: where(), steer(), drive(). Below tolerance: drive(0.0, 0.0), then succeed.
    """
    delivery = Delivery(learner)
    delivery.station('gate', 1.0, 0.2)
    goal = delivery.go('gate')
    expect(goal.accepted, 'The goal gate was rejected. The station is known, and so is the place of the robot.')
    delivery.run(10.0, goal)
    expect(goal.status == 'succeeded', f'After 10 s the goal is {goal.status or "still running"}, expected succeeded.')
    delivery.near('gate', 0.15)
    delivery.stands('The goal has succeeded')


def test_unknown_station(learner):
    """A station that nobody has set is rejected.

    place(name) is None then; look in the goal callback.
    """
    delivery = Delivery(learner)
    goal = delivery.go('moon')
    expect(goal.accepted is False, 'The goal moon was accepted, and nobody has set this station.')


def test_cancel(learner):
    """When the goal is cancelled, the robot stands at once.

    Look at is_cancel_requested in each round; drive(0.0, 0.0) before canceled().
    """
    delivery = Delivery(learner)
    delivery.station('far', 3.0, 0.0)
    goal = delivery.go('far')
    delivery.run(2.0)
    goal.cancel()
    delivery.run(0.3)
    expect(goal.status == 'canceled', f'0.3 s after the cancel request the goal is {goal.status or "still running"}, '
                                      'expected canceled.')
    delivery.stands('The goal was cancelled')
