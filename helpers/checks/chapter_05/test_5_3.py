"""Visible tests of exercise 5.3, the newest goal wins."""

import pytest
from example_interfaces.action import Fibonacci

from helpers.runner import expect

pytestmark = pytest.mark.exercise('5.3')


def test_one_goal(learner):
    """A goal of order 3 counts 1, 2, 3, one number every 0.5 s; the order 0 is rejected.

    This part is like exercise 5.1.
    """
    client = learner.action_client('/count', Fibonacci)
    learner.start('NewestWins', threads=True)
    goal, bad = client.send(order=3), client.send(order=0)
    learner.run(2.0)
    expect(bad.accepted is False, 'The order 0 was accepted.')
    expect(goal.status == 'succeeded', f'The goal of order 3 ended as {goal.status}, expected succeeded after 1.5 s. '
                                       'A goal that was rejected must not disturb it.')
    expect(list(goal.result.sequence) == [1, 2, 3], f'The result is {list(goal.result.sequence)}, expected [1, 2, 3].')
    expect(goal.stamps == pytest.approx([0.5, 1.0, 1.5]), f'Feedback came at {goal.stamps} s, expected 0.5, 1, 1.5 s.')


def test_newest_wins(learner):
    """A second goal after 1.2 s: the first one ends as aborted within 0.5 s, with [1, 2]; the second one runs.

    Remember the newest goal in handle_accepted_callback; the loop of an older one sees that it is not the newest.
    """
    client = learner.action_client('/count', Fibonacci)
    learner.start('NewestWins', threads=True)
    old = client.send(order=20)
    learner.run(1.2)
    new = client.send(order=3)
    learner.run(3.0)
    expect(new.accepted, 'The second goal was rejected. The newest goal wins.')
    expect(old.done, 'The first goal goes on beside the second one.')
    expect(old.status == 'aborted', f'The first goal ended as {old.status}, expected aborted.')
    expect(old.finished <= 1.7 + 1e-6, f'The second goal came at 1.2 s, and the first one ended at {old.finished:g} s, '
                                       'expected at 1.7 s at the latest.')
    expect(list(old.result.sequence) == [1, 2], f'The result of the first goal is {list(old.result.sequence)}, '
                                                'expected what it had, [1, 2].')
    expect(new.status == 'succeeded' and list(new.result.sequence) == [1, 2, 3],
           f'The second goal ended as {new.status}, expected succeeded with [1, 2, 3].')
