"""Visible tests of exercise 5.2, a client with a deadline."""

import pytest
from example_interfaces.action import Fibonacci
from std_msgs.msg import String

from helpers.runner import expect

pytestmark = pytest.mark.exercise('5.2')


def plan(goal):
    """One number every 0.5 s."""
    steps = [(0.5, Fibonacci.Feedback(sequence=range(n + 1))) for n in range(goal.order)]
    return [*steps, (0.0, Fibonacci.Result(sequence=range(goal.order)))]


def test_in_time(learner):
    """A goal that ends in time gives the outcome "succeeded [0, 1, 2]".

    Ask the goal handle for its result; the result message is in .result().result.
    """
    outcome = learner.listen('/outcome', String)
    server = learner.action_server('/fibonacci', Fibonacci, plan)
    learner.start('PatientClient', 3, 5.0)
    learner.run(8.0)
    expect(server.goals, 'No goal came in 8 s. Look for the server in a timer, and send the goal when it is ready.')
    expect(len(server.goals) == 1, f'{len(server.goals)} goals came, expected one.')
    expect(server.goals[0].request.order == 3, f'The goal has the order {server.goals[0].request.order}, expected 3.')
    expect(outcome.data == ['succeeded [0, 1, 2]'], f'/outcome said {outcome.data}, expected ["succeeded [0, 1, 2]"].')


def test_rejected(learner):
    """A goal that is rejected gives the outcome "rejected []".

    Look at accepted before you ask for a result.
    """
    outcome = learner.listen('/outcome', String)
    learner.action_server('/fibonacci', Fibonacci, accept=False)
    learner.start('PatientClient', 3, 5.0)
    learner.run(8.0)
    expect(outcome.data == ['rejected []'], f'The goal was rejected, and /outcome said {outcome.data}, '
                                            'expected ["rejected []"]. Look at accepted first.')


def test_deadline(learner):
    """A goal that takes too long is cancelled 2 s after it was accepted; the outcome is that of its result.

    A timer of `patience` seconds, made when the goal is accepted, sends the cancel request.
    """
    outcome = learner.listen('/outcome', String)
    server = learner.action_server('/fibonacci', Fibonacci, plan, partial=Fibonacci.Result(sequence=[7, 8]))
    learner.start('PatientClient', 20, 2.0)
    learner.run(6.0)
    expect(server.goals, 'No goal came in 6 s.')
    goal = server.goals[0]
    expect(goal.cancelled is not None, 'The goal took too long, and no cancel request came. To stop waiting is not '
                                       'enough: the robot would go on.')
    expect(goal.cancelled - goal.arrived == pytest.approx(2.0, abs=0.11),
           f'The cancel request came {goal.cancelled - goal.arrived:.2f} s after the goal, expected 2 s.')
    expect(outcome.data == ['canceled [7, 8]'], f'/outcome said {outcome.data}, expected ["canceled [7, 8]"]: wait for '
                                                'the result, which also a cancelled goal has.')
