"""Visible tests of exercise 5.1, a server that can be stopped."""

import pytest
from example_interfaces.action import Fibonacci

from helpers.runner import expect

pytestmark = pytest.mark.exercise('5.1')


def test_numbers(learner):
    """A goal of order 5 ends after 2.5 s with 0, 1, 1, 2, 3, and each number comes with a feedback.

    Wait 0.5 s on the node's clock, add one number, publish the feedback; at the end succeed() and return the result.
    """
    client = learner.action_client('/fibonacci', Fibonacci)
    learner.start('FibonacciServer', threads=True)
    goal = client.send(order=5)
    learner.run(4.0)
    expect(goal.accepted, 'The goal of order 5 was rejected.')
    expect(goal.done, 'The goal of order 5 did not end in 4 s.')
    expect(goal.status == 'succeeded', f'The goal ended as {goal.status}, expected succeeded. Call succeed() before '
                                       'you return the result.')
    numbers = list(goal.result.sequence)
    expect(numbers == [0, 1, 1, 2, 3], f'Order 5 gave {numbers}, expected the first five numbers, [0, 1, 1, 2, 3].')
    expect(goal.stamps == pytest.approx([0.5, 1.0, 1.5, 2.0, 2.5]),
           f'Feedback came at {goal.stamps} s, expected at 0.5, 1, 1.5, 2, 2.5 s: one for each number.')


def test_bad_goals(learner):
    """The orders -1 and 48 are rejected.

    Return GoalResponse.REJECT in the goal callback. The 48th number no longer fits into the type of the field, int32.
    """
    client = learner.action_client('/fibonacci', Fibonacci)
    learner.start('FibonacciServer', threads=True)
    goals = [client.send(order=order) for order in (-1, 48)]
    learner.settle()
    for goal in goals:
        expect(goal.accepted is False, f'The order {goal.request.order} was accepted. A server that knows that it '
                                       'cannot do it must say so at once.')


def test_cancel(learner):
    """A goal that is cancelled after 1.2 s ends as canceled, at the next step, with the two numbers so far.

    Accept in the cancel callback, look at is_cancel_requested in the loop, then canceled() and return what there is.
    """
    client = learner.action_client('/fibonacci', Fibonacci)
    learner.start('FibonacciServer', threads=True)
    goal = client.send(order=10)
    learner.run(1.2)
    cancel = goal.cancel()
    learner.settle()
    expect(cancel.done, 'The cancel request was not answered: no thread was free to hear it.')
    expect(cancel.answer == 'accepted', 'The cancel request was refused. The default cancel callback refuses all: give '
                                        'your own one.')
    learner.run(6.0)
    expect(goal.status == 'canceled', f'A cancelled goal ended as {goal.status}, expected canceled: ask '
                                      'is_cancel_requested in every step, and call canceled().')
    expect(goal.finished <= 1.5 + 1e-6, f'The goal was cancelled at 1.2 s and ended at {goal.finished:g} s, expected '
                                        'at the next step, 1.5 s.')
    expect(list(goal.result.sequence) == [0, 1], f'The result is {list(goal.result.sequence)}, expected the numbers so '
                                                 'far, [0, 1].')
