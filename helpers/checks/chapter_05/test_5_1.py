"""Visible tests of exercise 5.1, a server that can be stopped."""

import pytest
from example_interfaces.action import Fibonacci

from helpers.checks.chapter_05.fibonacci_numbers import SERIES, check_longest_feedback, check_own_results, check_threads
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('5.1'), pytest.mark.wiring(type='names', namespace='names')]


def numbers(goal) -> list[int]:
    return list(goal.result.sequence) if goal.result else []


def seconds(stamps, begin) -> list[float]:
    return [round(stamp - begin, 3) for stamp in stamps]


def check_goal(goal, rule='') -> None:
    """Expect that a goal that nobody has cancelled has done its work; `rule`: what is broken, if not the obvious."""
    order = goal.request.order
    expect(goal.accepted, f'The goal of order {order} {goal.answer}.', 'orders')
    expect(goal.done, f'The goal of order {order} did not end within {order / 2 + 1} s.', rule or 'rate')
    expect(
        goal.status == 'succeeded',
        f'The goal of order {order} {goal.ended}, expected succeeded. Call succeed() before you return the result.',
        rule or 'end',
    )
    expect(
        numbers(goal) == SERIES[:order],
        f'Order {order} gave {numbers(goal)}, expected the first {order} numbers, {SERIES[:order]}.',
        rule or 'numbers',
    )
    heard = [list(feedback.sequence) for feedback in goal.feedback]
    wanted = [SERIES[:n] for n in range(1, order + 1)]
    expect(
        len(heard) == order,
        f'{len(heard)} feedback messages came for {order} numbers, expected one for each number.',
        rule or 'feedback',
    )
    expect(heard == wanted, f'The feedback is {heard}, expected all numbers so far: {wanted}.', rule or 'feedback')
    hint = 'No goal waits for another one.' if rule == 'goals' else "Wait on the node's clock."
    stamps, due = seconds(goal.stamps, goal.sent), [n / 2 for n in range(1, order + 1)]
    expect(
        stamps == pytest.approx(due),
        f'Feedback came {stamps} s after the goal of order {order}, expected after '
        f'{due} s: one number every 0.5 s. {hint}',
        rule or 'rate',
    )
    took = round(goal.finished - goal.sent, 3)
    expect(
        took == order / 2,
        f'The goal of order {order} ended {took} s after its start, expected {order / 2} s.',
        rule or 'end',
    )


@pytest.mark.rules('names', 'orders', 'numbers', 'rate', 'feedback', 'end', 'goals')
@about('numbers')
def test_numbers(learner):
    """Each order from 0 to 47 gives that many numbers, one every 0.5 s, also if several goals run at a time.

    Wait 0.5 s on the node's clock, add one number, publish the feedback; at the end succeed() and return the result.
    """
    draw = learner.random
    space, order = draw.choice(['/arm', '/left/arm']), draw.choice([5, 6])
    node = learner.start('FibonacciServer', threads=True, remap={'__ns': space})
    expect(
        node.name == f'{space}/fibonacci_server',
        f'Your node is called {node.name}, expected {space}/fibonacci_server.',
        'names',
    )
    client = learner.action_client(f'{space}/fibonacci', Fibonacci)
    learner.run(draw.choice([0.2, 1.35]))
    expect(
        client.name in client.theirs(),
        f'Your node {node.name} has no action server {client.name}: write the name without a leading slash.',
        'names',
    )
    goal = client.send(order=order)
    learner.run(order / 2 + 1)
    check_goal(goal)
    for other in (0, 1, 2):
        goal = client.send(order=other)
        learner.run(other / 2 + 1)
        check_goal(goal, 'goals' if len(numbers(goal)) >= order else '')  # those of the first goal are still there
    orders = [draw.randint(3, 4), *draw.choices([3, 4, 5], k=draw.randint(9, 10)), draw.randint(5, 6)]
    goals = [client.send(order=order) for order in orders[:5]]
    learner.run(draw.choice([0.3, 0.7]))  # the last ones come while the others count
    goals += [client.send(order=order) for order in orders[5:]]
    learner.run(4.0)
    for goal in goals:
        expect(
            goal.status == 'succeeded'
            and numbers(goal) == SERIES[: goal.request.order]
            and len(goal.feedback) == goal.request.order,
            f'Goals of the orders {orders} ran at the same time. That of order {goal.request.order} ended as '
            f'{goal.status} with {numbers(goal)}. Keep what belongs to one goal in variables of execute.',
            'goals',
        )
        check_goal(goal, 'goals')
    check_own_results(learner, goals)
    bad = [-1, 48, -draw.randint(2, 2**31), draw.randint(49, 2**31 - 1)]
    sent = [client.send(order=order) for order in [*bad, 47]]
    learner.settle()
    for goal in sent[:-1]:
        expect(
            goal.accepted is False,
            f'The order {goal.request.order} was accepted. A server that knows that it '
            'cannot do it must say so at once.',
            'orders',
        )
    expect(sent[-1].accepted, f'The order 47 {sent[-1].answer}. The 47 numbers fit into the field.', 'orders')
    _check_largest(learner, sent[-1])


def _check_largest(learner, goal):
    """Expect all 47 numbers, also the large ones, and all feedback."""
    learner.run(23.6, step=0.5)
    expect(goal.done, 'The goal of order 47 did not end within 23.6 s.', 'rate')
    wrong = [n for n, (mine, right) in enumerate(zip(numbers(goal), SERIES, strict=False)) if mine != right]
    first = wrong[0] if wrong else 0
    expect(
        not wrong,
        f'Order 47: number {first + 1} is {[*numbers(goal), 0][first]}, expected {SERIES[first]}. Add the two numbers '
        'before it: a formula with decimal numbers is not exact when the numbers are large.',
        'numbers',
    )
    expect(
        numbers(goal) == SERIES,
        f'The goal of order 47 {goal.ended} with {len(numbers(goal))} numbers, expected 47.',
        'numbers',
    )
    check_longest_feedback(goal)


@pytest.mark.rules('cancel', 'partial', 'goals')
@about('cancel')
def test_cancel(learner):
    """A goal that is cancelled ends as canceled, at the next step, with the numbers so far; other goals go on.

    Accept in the cancel callback, look at is_cancel_requested after each wait, then canceled() and return the numbers.
    """
    draw = learner.random
    client = learner.action_client('/fibonacci', Fibonacci)
    learner.start('FibonacciServer', threads=True)
    steps = [(9, 0), (9, 1), (9, draw.choice([2, 4])), (9, draw.choice([3, 5]))]
    draw.shuffle(steps)
    late = draw.randint(12, 42)
    for order, step in [*steps, (late + draw.randint(2, 5), late), (5, 4), (1, 0)]:  # at last, in the last step
        goal = client.send(order=order)
        learner.run(step / 2, step=0.5)
        learner.run(draw.choice([0.1, 0.2, 0.4]))
        check_accepted(client, goal)
        begin = learner.now / 1e9 - goal.sent
        words = f'A goal of order {order} was cancelled {begin:.1f} s after its start, with {SERIES[:step]} there. '
        cancel = goal.cancel()
        learner.settle()
        expect(cancel.done, f'{words}The cancel request was not answered: no thread was free to hear it.', 'cancel')
        hint = 'The default cancel callback refuses all: give your own one.' if cancel.answer == 'rejected' else ''
        expect(
            cancel.answer == 'accepted', f'{words}The cancel request was answered: {cancel.answer}. {hint}', 'cancel'
        )
        learner.run(0.5 * (step + 1) - begin)
        expect(
            goal.done,
            f'{words}It did not end at the next step, after {0.5 * (step + 1)} s: look at '
            'is_cancel_requested in every step.',
            'cancel',
        )
        expect(
            len(numbers(goal)) <= step and len(goal.feedback) <= step,
            f'{words}It went on after the cancel request: {len(goal.feedback)} feedback messages, the result '
            f'{numbers(goal)}. Look at is_cancel_requested after each wait, before you add a number.',
            'partial',
        )
        expect(goal.status == 'canceled', f'{words}It {goal.ended}, expected canceled: call canceled().', 'cancel')
        expect(
            numbers(goal) == SERIES[:step],
            f'{words}The result is {numbers(goal)}, expected the numbers so far.',
            'partial',
        )
    for left in (2, draw.randint(0, 1)):  # the one that came last, and an earlier one
        _two_of_three(learner, client, left)


def check_accepted(client, goal) -> None:
    """Expect that this newest goal of the client's, with an order that can be done, has been accepted."""
    order = goal.request.order
    if len(client.goals) == 1:
        expect(goal.accepted, f'The first goal, of order {order}, {goal.answer}. It can be done.', 'orders')
    expect(
        goal.accepted,
        f'A goal of order {order} came after others, which had ended, and it {goal.answer}. Several goals may run, '
        'also one after the other.',
        'goals',
    )


def _two_of_three(learner, client, left):
    """Of three goals, two are cancelled within one step; the third one, with the number `left`, is not disturbed."""
    goals = [client.send(order=4) for _ in range(3)]
    learner.run(0.7)
    goals.append(goals.pop(left))
    for goal in goals[:2]:
        goal.cancel()
    with about('goals'):
        learner.run(2.0)
    statuses = [goal.status for goal in goals]
    expect(
        statuses != ['canceled', 'canceled', 'aborted'] or goals[2].finished - goals[2].sent < 2,
        f'Of three goals two were cancelled; the third one, of order 4, {goals[2].ended} when it had all numbers, '
        f'expected succeeded.{goals[2].why_aborted}',
        'end',
    )
    expect(
        statuses == ['canceled', 'canceled', 'succeeded'],
        'Three goals ran at the same time, and two of them were cancelled, both between two steps; these two ended as '
        f'{[goal.status or "still running" for goal in goals[:2]]}, the third one as '
        f'{goals[2].status or "still running"}. Ask each goal handle, and keep no flag of your own, nor '
        'the goal that was cancelled.',
        'goals',
    )
    check_goal(goals[2], 'goals')


@pytest.mark.rules('goals')
@about('goals')
def test_threads(learner):
    """Two goals make their steps at the same moments; whichever thread goes on first, each tells its own numbers.

    Several threads run your execute: what it keeps in self, they share.
    """
    check_threads(learner)
