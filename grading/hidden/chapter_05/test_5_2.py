"""Hidden tests of exercise 5.2, a client with a deadline."""

import pytest
from example_interfaces.action import Fibonacci
from std_msgs.msg import String

from helpers.runner import actions, expect

pytestmark = pytest.mark.exercise('5.2')
NEAR = 0.011  # s


def plan(goal):
    """One number every 0.5 s."""
    steps = [(0.5, Fibonacci.Feedback(sequence=range(n + 1))) for n in range(goal.order)]
    return [*steps, (0.0, Fibonacci.Result(sequence=range(goal.order)))]


def begin(learner, order, patience, steps=plan, **server):
    outcome = learner.listen('/outcome', String)
    server = learner.action_server('/fibonacci', Fibonacci, steps, **server)
    return outcome, server, learner.start('PatientClient', order, patience)


@pytest.mark.weight(2)
def test_in_time(learner):
    """A goal that ends in time is not cancelled, also not afterwards, and has one outcome.

    Cancel the timer of the deadline when the result comes.
    """
    order = learner.random.randint(2, 5)
    outcome, server, node = begin(learner, order, 3.0)
    learner.run(6.0)
    expect(node.name == '/patient_client', f'Your node is called {node.name}, expected /patient_client.')
    expect([goal.request.order for goal in server.goals] == [order],
           f'The orders {[goal.request.order for goal in server.goals]} came, expected one goal, {order}.')
    expect(outcome.data == [f'succeeded {list(range(order))}'],
           f'/outcome said {outcome.data}, expected ["succeeded {list(range(order))}"], once.')
    expect(not server.cancel_stamps, 'A cancel request came for a goal that ended in time.')
    expect(server.goals[0].arrived < 0.35, f'The goal came {server.goals[0].arrived:g} s after the start.')


@pytest.mark.weight(2)
def test_deadline(learner):
    """The cancel request comes `patience` seconds after the goal was accepted; then the result is waited for.

    The server may need time to stop. Its result tells what really happened.
    """
    patience = learner.random.choice([1.25, 1.7, 2.35])
    outcome, server, _ = begin(learner, 30, patience, cancel_delay=3.0, partial=Fibonacci.Result(sequence=[5, 6]))
    learner.run(patience + 1.8)
    expect(server.goals, 'No goal came.')
    goal = server.goals[0]
    expect(goal.cancelled is not None, 'The deadline passed, and no cancel request came: to stop waiting does not stop '
                                       'the robot.')
    expect(goal.cancelled - goal.arrived == pytest.approx(patience, abs=NEAR),
           f'The cancel request came {goal.cancelled - goal.arrived:.2f} s after the goal was accepted, expected '
           f'{patience:g} s.')
    expect(not outcome.data, f'/outcome said {outcome.data} before the result was there. The server had accepted the '
                             'cancel request and was still stopping: wait for its result.')
    learner.run(3.0)
    expect(outcome.data == ['canceled [5, 6]'], f'/outcome said {outcome.data}, expected ["canceled [5, 6]"].')


def test_rejected(learner):
    """A rejected goal has no result and no deadline.

    Look at accepted first.
    """
    outcome, server, _ = begin(learner, 3, 1.0, accept=False)
    learner.run(4.0)
    expect(outcome.data == ['rejected []'], f'The goal was rejected, and /outcome said {outcome.data}. '
                                            'Look at accepted first.')
    expect(len(server.goals) == 1, f'{len(server.goals)} goals came, expected one.')


def test_aborted(learner):
    """A goal that the server gives up has the outcome "aborted".

    The status stands beside the result: .result().status.
    """
    outcome, _, _ = begin(learner, 3, 3.0, [(1.0, actions.Aborted(Fibonacci.Result(sequence=[9])))])
    learner.run(5.0)
    expect(outcome.data == ['aborted [9]'], f'The server aborted the goal, and /outcome said {outcome.data}, '
                                            'expected ["aborted [9]"]. Look at the status of the result.')


@pytest.mark.weight(2)
def test_cancel_in_vain(learner):
    """A server may refuse to cancel, or end the goal all the same: the result says what happened.

    A cancel request is a request. Report the status of the result.
    """
    for cancel in ('reject', 'ignore'):
        outcome, server, node = begin(learner, 8, 2.0, cancel=cancel)
        learner.run(7.0)
        expect(outcome.data == [f'succeeded {list(range(8))}'],
               f'The goal went on after the cancel request ({cancel}) and succeeded; /outcome said {outcome.data}. '
               'Report what the result says.')
        node.stop()
        server.stop()


def test_race(learner):
    """The result may come at the moment of the deadline: there is one outcome, and it is true.

    One place that publishes, and timers that are cancelled.
    """
    outcome, server, _ = begin(learner, 4, 2.0)
    learner.run(6.0)
    expect(outcome.data in (['succeeded [0, 1, 2, 3]'], ['canceled []']),
           f'The result came at the moment of the deadline, and /outcome said {outcome.data}.')
    expect(outcome.data[0].split()[0] == server.goals[0].status,
           f'The goal ended as {server.goals[0].status}, and /outcome said {outcome.data}.')


@pytest.mark.weight(2)
def test_server_is_gone(learner):
    """A server that ends in between never answers: 1 s after the cancel request the outcome is "lost".

    The numbers are those of the last feedback: message.feedback.sequence.
    """
    outcome, server, _ = begin(learner, 30, 2.0)
    learner.run(1.5)
    server.stop()
    seen = [0, 1] if server.goals and server.goals[0].arrived < 0.4 else None
    learner.run(5.0)
    expect(outcome.data, 'The server ended while the goal ran, and /outcome says nothing: the client waits for ever.')
    expect(outcome.data == [f'lost {seen}'], f'The server ended after the feedback {seen}; /outcome said '
                                             f'{outcome.data}, expected ["lost {seen}"].')
    arrived = server.goals[0].arrived
    expect(outcome.stamps[0] - arrived == pytest.approx(3.0, abs=2 * NEAR),
           f'The outcome came {outcome.stamps[0] - arrived:.2f} s after the goal, expected 3 s: the deadline after '
           '2 s, and 1 s for an answer.')


def test_server_comes_late(learner):
    """The client may start before the server. Its constructor returns at once, and the deadline begins with the goal.

    Look for the server in a timer; never wait in a constructor.
    """
    outcome = learner.listen('/outcome', String)
    server = learner.action_server('/fibonacci', Fibonacci, plan)
    server.stop()
    learner.start('PatientClient', 2, 1.5)
    learner.run(4.0)
    expect(not outcome.data, f'There is no server, and /outcome said {outcome.data}.')
    server.start()
    learner.run(4.0)
    expect(len(server.goals) == 1, f'The server came after 4 s, and {len(server.goals)} goals came in the 4 s after '
                                   'that, expected one.')
    expect(outcome.data == ['succeeded [0, 1]'], f'/outcome said {outcome.data}, expected ["succeeded [0, 1]"]: the '
                                                 'deadline begins when the goal is accepted.')


def test_two_clients(learner):
    """Two clients of one server each have their own goal and outcome.

    Keep all state in the object.
    """
    left, right = learner.listen('/left/outcome', String), learner.listen('/right/outcome', String)
    server = learner.action_server('/fibonacci', Fibonacci, plan, partial=Fibonacci.Result(sequence=[4]))
    remap = {f'fibonacci/_action/{end}': f'/fibonacci/_action/{end}'
             for end in ('send_goal', 'cancel_goal', 'get_result', 'feedback', 'status')}
    learner.start('PatientClient', 2, 2.0, remap={'__ns': '/left', **remap})
    learner.start('PatientClient', 20, 2.0, remap={'__ns': '/right', **remap})
    learner.run(4.0)
    expect(len(server.goals) == 2, f'Two clients sent {len(server.goals)} goals.')
    expect((left.data, right.data) == (['succeeded [0, 1]'], ['canceled [4]']),
           f'Two clients with a short and a long goal said {left.data} and {right.data}.')
