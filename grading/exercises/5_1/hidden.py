"""Hidden tests of exercise 5.1, a server that can be stopped."""

import pytest
from example_interfaces.action import Fibonacci

from helpers.checks.chapter_05.fibonacci_numbers import SERIES, check_longest_feedback, check_own_results, check_threads
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('5.1'), pytest.mark.wiring(type='names', namespace='names')]


def serve(learner):
    client = learner.action_client('/fibonacci', Fibonacci)
    return client, learner.start('FibonacciServer', threads=True)


@pytest.mark.weight(2)
@pytest.mark.rules('names', 'orders', 'end', 'goals', 'rate', 'numbers')
@about('goals')
def test_orders(learner):
    """Each order gives that many numbers, also 0 and 1, and several goals run side by side.

    Keep the numbers of a goal in a variable of execute. An order of 0 ends at once, with no number.
    """
    client, node = serve(learner)
    expect(node.name == '/fibonacci_server', f'Your node is called {node.name}, expected /fibonacci_server.', 'names')
    draw = learner.random
    alone = client.send(order=2)
    learner.run(1.5)
    expect(
        alone.finished and alone.finished - alone.sent == pytest.approx(1.0),
        f'A goal of order 2, alone, ended at {alone.finished} s, expected {alone.sent + 1:g} s.',
        'rate',
    )
    goals = [client.send(order=order) for order in (0, 1, 2, draw.randint(3, 6), 3, 2, 4, draw.randint(7, 9))]
    learner.settle()
    goals += [client.send(order=draw.randint(3, 6)) for _ in range(draw.randint(6, 7))]
    learner.run(5.0)
    for goal in goals:
        order = goal.request.order
        expect(goal.accepted, f'The order {order} was rejected.', 'orders')
        expect(goal.status == 'succeeded', f'The goal of order {order} {goal.ended}, expected succeeded.', 'end')
        numbers = list(goal.result.sequence)
        expect(
            numbers == SERIES[:order],
            f'Order {order} gave {numbers}, expected {SERIES[:order]}. Several goals ran at a time.',
            'goals',
        )
        expect(
            goal.finished - goal.sent == pytest.approx(order / 2),
            f'The goal of order {order} ended after {goal.finished - goal.sent:g} s, expected {order / 2:g} s. Several '
            'goals ran at a time.',
            'goals' if order else 'end',
        )
    check_own_results(learner, goals)


@pytest.mark.rules('feedback', 'rate')
@about('feedback')
def test_feedback(learner):
    """There is one feedback for each number, with all numbers so far, when it is there.

    publish_feedback belongs into the loop, once for each number.
    """
    client, _ = serve(learner)
    learner.run(learner.random.choice([0.2, 0.35]))
    goal = client.send(order=6)
    learner.run(3.5)
    expect(goal.feedback, 'No feedback came.', 'feedback')
    expect(
        len(goal.feedback) <= 6, f'{len(goal.feedback)} feedback messages came for 6 numbers: do not flood.', 'feedback'
    )
    heard = [list(feedback.sequence) for feedback in goal.feedback]
    expect(
        heard == [SERIES[:n] for n in range(1, 7)],
        f'The feedback is {heard}, expected one more number each time.',
        'feedback',
    )
    expect(
        goal.stamps == pytest.approx([goal.sent + n / 2 for n in range(1, 7)]),
        f'Feedback came {[round(stamp - goal.sent, 3) for stamp in goal.stamps]} s after the goal, expected '
        "every 0.5 s. Wait on the node's clock.",
        'rate',
    )


@pytest.mark.rules('orders', 'numbers', 'feedback', 'rate')
@about('numbers')
def test_limits(learner):
    """Orders below 0 and above 47 are rejected, at once; 0 and 47 are accepted.

    2971215073, the 48th number, does not fit into an int32.
    """
    client, _ = serve(learner)
    bad = [
        client.send(order=order)
        for order in (-1, 48, -learner.random.randint(2, 2**31), learner.random.randint(49, 2**31 - 1))
    ]
    good = [client.send(order=order) for order in (0, 47)]
    learner.settle()
    for goal in bad:
        expect(goal.accepted is False, f'The order {goal.request.order} was accepted.', 'orders')
    for goal in good:
        expect(goal.accepted, f'The order {goal.request.order} was rejected. It can be done.', 'orders')
    learner.run(23.6, step=0.5)
    expect(
        list(good[1].result.sequence) == SERIES if good[1].result else False,
        f'The goal of order 47 {good[1].ended} with {good[1].result and list(good[1].result.sequence)}, '
        'expected all 47 numbers, each one the exact sum of the two before it.',
        'numbers',
    )
    check_longest_feedback(good[1])


@pytest.mark.weight(3)
@pytest.mark.rules('cancel', 'partial', 'goals')
@about('cancel')
def test_cancel_at_any_step(learner):
    """A goal can be cancelled in each of its steps; it ends as canceled with the numbers so far, and adds no other one.

    After each wait, look at is_cancel_requested first.
    """
    client, _ = serve(learner)
    goals = [client.send(order=5) for _ in range(6)]
    for step, goal in enumerate(goals[:5]):
        cancel = goal.cancel()
        learner.settle()
        expect(
            cancel.done, 'A cancel request was not answered while the goal ran. Nobody was free to hear it.', 'cancel'
        )
        expect(cancel.answer == 'accepted', f'A cancel request in step {step} was refused.', 'cancel')
        learner.run(0.5)
        expect(
            goal.done,
            f'A goal that was cancelled in step {step} did not end at the next step. '
            'Look at is_cancel_requested in each step.',
            'cancel',
        )
        numbers = list(goal.result.sequence)
        expect(
            len(numbers) <= step,
            f'A goal cancelled after {step} numbers has {len(numbers)} in its result: it went '
            'on after the cancel request.',
            'partial',
        )
        expect(goal.status == 'canceled', f'A goal cancelled in step {step} {goal.ended}.', 'cancel')
        expect(
            numbers == SERIES[:step],
            f'A goal cancelled after {SERIES[:step]} has the result {numbers}: return the numbers so far.',
            'partial',
        )
        expect(
            len(goal.feedback) == step,
            f'A goal cancelled after {step} numbers gave {len(goal.feedback)} feedback.',
            'partial',
        )
    expect(
        goals[5].status == 'succeeded',
        'One goal was not cancelled, but it did not succeed: each goal is its own.',
        'goals',
    )
    _cancel_late(client, learner, learner.random.randint(15, 45))


def _cancel_late(client, learner, step):
    """Also a goal that has run for long can be cancelled."""
    goal = client.send(order=46)
    learner.run(step / 2, step=0.5)
    learner.run(0.3)
    cancel = goal.cancel()
    learner.run(0.2)
    expect(
        cancel.answer == 'accepted', f'A cancel request in step {step} of 46 was answered: {cancel.answer}.', 'cancel'
    )
    expect(
        goal.status == 'canceled',
        f'A goal that was cancelled in step {step} of 46 is {goal.status or "still running"} at the next step.',
        'cancel',
    )
    numbers = list(goal.result.sequence)
    expect(numbers == SERIES[:step], f'A goal cancelled after {SERIES[:step]} has the result {numbers}.', 'partial')


@pytest.mark.rules('cancel', 'end')
@about('cancel')
def test_cancel_races(learner):
    """A cancel request may come together with the goal, twice, or too late.

    rclpy keeps the states: ask the goal handle, and keep no flag of your own.
    """
    client, _ = serve(learner)
    goal = client.send(order=2)
    learner.run(0.1)
    first, second = goal.cancel(), goal.cancel()
    short = client.send(order=1)
    learner.run(0.6)
    expect(
        first.answer == 'accepted' and goal.status == 'canceled',
        f'A goal that was cancelled twice {goal.ended}, expected canceled.',
        'cancel',
    )
    expect(second.done, 'The second cancel request for a goal was not answered.', 'cancel')
    late = short.cancel()
    learner.run(0.6)
    expect(short.status == 'succeeded', f'A goal cancelled after its end is {short.status}, expected succeeded.', 'end')
    expect(
        late.answer in ('goal has ended', 'unknown goal'),  # a server may forget a goal that has ended
        f'A cancel request after the end was answered: {late.answer}.',
        'cancel',
    )


@pytest.mark.rules('goals', 'cancel')
@about('goals')
def test_two_clients(learner):
    """Two clients have a goal each; one cancels, the other one is not disturbed. "Cancel all" stops both.

    Two goals run at the same time: nothing of a goal may live in self.
    """
    left, node = serve(learner)
    right = learner.action_client('/fibonacci', Fibonacci)
    mine = left.send(order=8)
    learner.run(0.2)
    other = right.send(order=3)
    learner.run(0.5)
    mine.cancel()
    learner.run(2.0)
    expect(mine.status == 'canceled', f'The cancelled goal of one client {mine.ended}.', 'cancel')
    expect(
        other.status == 'succeeded' and list(other.result.sequence) == [0, 1, 1],
        f'One client cancelled; the goal of the other client {other.ended}, expected succeeded.',
        'goals',
    )
    goals = [left.send(order=9), right.send(order=9)]
    learner.run(0.7)
    left.cancel()
    learner.run(1.0)
    expect(
        [goal.status for goal in goals] == ['canceled', 'canceled'], '"Cancel all" did not cancel both goals.', 'cancel'
    )


@pytest.mark.rules('names')
def test_restart(learner):
    """A server that is started again serves as before, also in a namespace, and remembers nothing.

    A relative name, and state in the object.
    """
    client = learner.action_client('/arm/fibonacci', Fibonacci)
    first = learner.start('FibonacciServer', threads=True, remap={'__ns': '/arm'})
    lost = client.send(order=20)
    learner.run(1.0)
    first.stop()
    learner.start('FibonacciServer', threads=True, remap={'__ns': '/arm'})
    goal = client.send(order=2)
    learner.run(1.5)
    expect(not lost.done, 'The goal of the server that ended has a result.')
    expect(
        goal.status == 'succeeded' and list(goal.result.sequence) == [0, 1],
        f'After a restart of the server the goal of order 2 {goal.ended}.',
    )


@pytest.mark.rules('goals')
@about('goals')
def test_threads(learner):
    """Two goals make their steps at the same moments; whichever thread goes on first, each tells its own numbers.

    A Feedback in self belongs to all goals; one that is made in execute belongs to one.
    """
    check_threads(learner)
