"""Hidden tests of exercise 5.3, the newest goal wins."""

import pytest
from example_interfaces.action import Fibonacci

from helpers.checks.chapter_05.counting import check_own_results, check_script, up_to
from helpers.checks.chapter_05.test_5_3 import check_long, check_threads, check_two_servers
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('5.3'), pytest.mark.wiring(type='names', namespace='names')]


def serve(learner):
    client = learner.action_client('/count', Fibonacci)
    return client, learner.start('NewestWins', threads=True)


@pytest.mark.weight(3)
@pytest.mark.rules('newest', 'names', 'aborted', 'stops')
@about('newest')
def test_newest_wins(learner):
    """A new goal ends the old one: aborted within 0.5 s, with the numbers that it had when the new one came.

    abort() is for a goal that the server gives up; canceled() only for one that a client asked to cancel.
    """
    client, node = serve(learner)
    expect(node.name == '/newest_wins', f'Your node is called {node.name}, expected /newest_wins.', 'names')
    draw = learner.random
    same = draw.randint(2, 5)
    cases = [
        (draw.randint(31, 2**31 - 1), draw.randint(1, 4), 4),
        (draw.randint(51, 2**31 - 1), draw.randint(11, 40), 2),
        (5, 4, 7),
        (same, 0, same),
        (6, draw.randint(1, 3), 6),
    ]
    draw.shuffle(cases)
    for case in cases:
        check_replaced(learner, client, *case)
    check_own_results(learner, client)


@pytest.mark.weight(2)
@pytest.mark.rules('orders', 'count', 'newest', 'stops', 'aborted', 'rejected', 'cancel')
@about('newest')
def test_goals_at_any_time(learner):
    """Whenever goals come, replace each other and are cancelled: each ends as the card says.

    Each goal looks for itself, after each wait, whether it was cancelled and whether it is still the newest.
    """
    check_script(learner, 20)


def check_replaced(learner, client, order, count, newer):
    """A goal of this order, with `count` numbers, gives way to one of the order `newer`."""
    old = client.send(order=order)
    learner.run(0.5 * count, step=0.5)
    learner.run(0.2)
    expect(old.accepted, f'The order {order} was rejected.', 'orders')
    new = client.send(order=newer)
    learner.run(0.5)
    expect(new.accepted, f'A new goal {new.answer} while another one ran. The newest goal wins.', 'newest')
    expect(
        old.done,
        f'A goal of order {newer} was accepted, and the old one, of order {order}, did not end within 0.5 s.',
        'aborted',
    )
    expect(len(old.feedback) <= count, 'The old goal sent feedback after the new one had come.', 'stops')
    expect(
        old.status == 'aborted',
        f'The old goal {old.ended}, expected aborted: a newer one has taken its place.',
        'aborted',
    )
    expect(
        list(old.result.sequence) == up_to(count),
        f'The old goal had {up_to(count)} when the new one came, and its result is {list(old.result.sequence)}.',
        'stops' if len(old.result.sequence) > count else 'aborted',
    )
    learner.run(0.5 * newer - 0.4)
    expect(
        new.status == 'succeeded' and list(new.result.sequence) == up_to(newer),
        f'The new goal {new.ended}, expected succeeded with {up_to(newer)}. Each goal counts for itself.',
        'newest',
    )
    took = new.finished - new.sent
    expect(
        took == pytest.approx(newer / 2),
        f'The new goal of order {newer} took {took:g} s, expected {newer / 2:g} s: it begins at once. Each goal counts '
        'for itself.',
        'newest',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('newest', 'aborted')
@about('newest')
def test_many_goals(learner):
    """Of several goals in a row, also at the same moment, only the last one succeeds, and after it the next one.

    Compare with the newest goal; a flag would also stop the one that comes after.
    """
    client, _ = serve(learner)
    goals = [client.send(order=5) for _ in range(3)]
    learner.run(0.7)
    ends = [goal.status for goal in goals]
    expect(
        ends == ['aborted', 'aborted', None],
        f'Three goals came at one moment; 0.7 s later they have ended as {ends}, expected the first two aborted.',
        'aborted',
    )
    goals.append(client.send(order=2))
    learner.run(1.5)
    after = client.send(order=1)
    learner.run(1.0)
    expect(all(goal.accepted for goal in goals), 'A goal was rejected because another one ran.', 'newest')
    expect(
        goals[2].status == 'aborted' and list(goals[2].result.sequence) == [1],
        f'The third of three goals had counted to 1 when the fourth came; it {goals[2].ended}.',
        'aborted',
    )
    expect(goals[3].status == 'succeeded', f'The last goal {goals[3].ended}, expected succeeded.', 'newest')
    expect(after.status == 'succeeded', f'A goal that came when nothing ran {after.ended}.', 'newest')


@pytest.mark.rules('newest', 'aborted')
@about('newest')
def test_threads(learner):
    """Of two goals that come at one moment the second is the newest, whichever thread is the first to go on.

    handle_accepted_callback is called in the order of the goals; two execute callbacks may begin in any order.
    """
    check_threads(learner)


@pytest.mark.weight(2)
@pytest.mark.rules('rejected', 'orders')
@about('rejected')
def test_rejected_goals_disturb_nobody(learner):
    """A goal below 1 is rejected, and the goal that runs goes on.

    The goal callback only decides. What has to happen for a goal that was accepted belongs into
    handle_accepted_callback.
    """
    client, _ = serve(learner)
    goal = client.send(order=4)
    learner.run(0.7)
    bad = [client.send(order=0), client.send(order=-learner.random.randint(1, 99))]
    learner.run(2.0)
    expect([other.accepted for other in bad] == [False, False], 'An order below 1 was accepted.', 'orders')
    expect(
        goal.status == 'succeeded',
        f'A goal was rejected, and the goal that ran {goal.ended}: only an accepted goal takes over.',
        'rejected',
    )


@pytest.mark.rules('cancel', 'newest', 'orders')
@about('cancel')
def test_cancel(learner):
    """A goal can be cancelled: canceled within 0.5 s, with the numbers so far. Then another one can run.

    As in exercise 5.1.
    """
    client, _ = serve(learner)
    draw = learner.random
    late = draw.randint(11, 40)
    for order, count in (
        (draw.randint(48, 2**31 - 1), 0),
        (9, 1),
        (9, draw.choice([2, 4])),
        (late + draw.randint(2, 9), late),
        (1, 0),
        (4, 3),
    ):
        goal = client.send(order=order)
        learner.run(0.5 * count, step=0.5)
        learner.run(0.2)
        expect(goal.accepted, f'The order {order} was rejected.', 'orders')
        words = f'A goal of order {order} was cancelled with {up_to(count)} there. '
        cancel = goal.cancel()
        learner.run(0.5)
        expect(cancel.answer == 'accepted', f'{words}The cancel request was not accepted.', 'cancel')
        expect(goal.status == 'canceled', f'{words}It {goal.ended}, expected canceled.', 'cancel')
        expect(
            list(goal.result.sequence) == up_to(count), f'{words}The result is {list(goal.result.sequence)}.', 'cancel'
        )
    goal = client.send(order=8)
    learner.run(1.1)
    goal.cancel()
    learner.settle()
    after = client.send(order=3)
    learner.run(1.6)
    expect(
        after.status == 'succeeded',
        f'A goal was cancelled, and at the same moment a new one came. The new one {after.ended}, expected '
        'succeeded: what the old goal does at its end must not touch the new one.',
        'newest',
    )
    after = client.send(order=1)
    learner.run(0.6)
    expect(after.status == 'succeeded', f'The goal after a cancelled one {after.ended}.', 'newest')


@pytest.mark.rules('count', 'feedback', 'succeeds')
@about('count')
def test_alone(learner):
    """A goal that nobody disturbs counts to its order, one number every 0.5 s, with one feedback for each.

    As in exercise 5.1.
    """
    client, _ = serve(learner)
    learner.run(0.3)
    order = learner.random.randint(2, 6)
    goal = client.send(order=order)
    learner.run(order / 2 + 1.0)
    expect(goal.status in (None, 'succeeded'), f'A goal alone {goal.ended}, expected succeeded.', 'succeeds')
    expect(
        goal.status and list(goal.result.sequence) == up_to(order),
        f'A goal of order {order} did not end with {up_to(order)}.',
        'count',
    )
    took = goal.finished - goal.sent
    expect(took == pytest.approx(order / 2), f'Order {order} took {took:g} s, expected {order / 2} s.', 'count')
    expect(len(goal.stamps) == order, f'{len(goal.stamps)} feedback messages came for {order} numbers.', 'feedback')
    said = [list(feedback.sequence) for feedback in goal.feedback]
    expect(
        said == [up_to(n) for n in up_to(order)],
        f'The feedback is {said}; each one has all numbers so far, from 1.',
        'feedback',
    )
    expect(
        [stamp - goal.sent for stamp in goal.stamps] == pytest.approx([n / 2 for n in up_to(order)]),
        f'The numbers came at {goal.stamps} s.',
        'count',
    )
    check_long(learner, client, learner.random.randint(40, 70))


@pytest.mark.rules('aborted')
@about('aborted')
def test_two_clients(learner):
    """The goals of two clients share one server: the newest wins, whoever sent it.

    The policy is the server's.
    """
    left, _ = serve(learner)
    right = learner.action_client('/count', Fibonacci)
    first = left.send(order=9)
    learner.run(0.6)
    second = right.send(order=2)
    learner.run(1.5)
    expect(
        (first.status, second.status) == ('aborted', 'succeeded'),
        f'Two clients sent a goal each; the first one {first.ended}, expected aborted, and the second one '
        f'{second.ended}, expected succeeded.',
    )


@pytest.mark.rules('newest')
@about('newest')
def test_two_servers(learner):
    """Two objects of the class in one program do not disturb each other.

    All state in the object.
    """
    check_two_servers(learner)


@pytest.mark.rules('names')
@about('names')
def test_restart(learner):
    """A second server, after the first one has ended, begins with nothing, also in a namespace.

    A relative name, and state in the object.
    """
    client = learner.action_client('/shop/count', Fibonacci)
    first = learner.start('NewestWins', threads=True, remap={'__ns': '/shop'})
    client.send(order=9)
    learner.run(0.7)
    first.stop()
    learner.start('NewestWins', threads=True, remap={'__ns': '/shop'})
    goal = client.send(order=1)
    learner.run(1.0)
    expect(goal.status == 'succeeded', f'After a restart of the server a goal {goal.ended}.')
