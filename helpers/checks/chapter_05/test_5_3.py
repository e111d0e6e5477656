"""Visible tests of exercise 5.3, the newest goal wins."""

import pytest
from example_interfaces.action import Fibonacci

from helpers.checks.chapter_05.counting import check_own_results, check_script, up_to
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('5.3'), pytest.mark.wiring(type='names', namespace='names')]

MOST_PLACES = 80  # in the learner's lines, to which threads come when two goals begin
PLACES_AT_LOOK = 4  # of those to which they come after their wait, the first ones


def numbers(goal) -> list[int]:
    return list(goal.result.sequence) if goal.result else []


def _newest(goal) -> str:
    """For the end of a message, where the newest goal was not to be aborted."""
    return ' If it was abort(): was this goal still the newest one?' if goal.status == 'aborted' else ''


def check_goal(goal, story='', rule='') -> None:
    """Expect that a goal has counted to its order; `rule`: what is broken, if not the obvious."""
    order = goal.request.order
    words = f'{story}The goal of order {order} '
    expect(goal.accepted, f'{words}{goal.answer}.', rule or 'orders')
    heard = [round(stamp - goal.sent, 3) for stamp in goal.stamps]
    due = [n / 2 for n in up_to(order)]
    expect(
        goal.status in ('succeeded', None) or rule,
        f'{words}{goal.ended}, expected succeeded.{goal.why_aborted}{_newest(goal)}',
        'succeeds',
    )
    expect(
        goal.status or 'executing' in goal.statuses,
        f'{words}was accepted, and never begun: handle_accepted_callback must call goal.execute().',
        rule or 'count',
    )
    expect(goal.status == 'succeeded', f'{words}{goal.ended}, expected succeeded after {order / 2} s.', rule or 'count')
    expect(
        numbers(goal) == up_to(order),
        f'{words}has the result {numbers(goal)}, expected {up_to(order)}.',
        rule or 'count',
    )
    took = round(goal.finished - goal.sent, 3)
    expect(
        took == order / 2,
        f"{words}ended after {took} s, expected after {order / 2} s: one number every 0.5 s of the node's clock.",
        rule or 'count',
    )
    expect(
        len(heard) == order,
        f'{words}sent {len(heard)} feedback messages, expected one for each number.',
        rule or 'feedback',
    )
    said = [list(feedback.sequence) for feedback in goal.feedback]
    wanted = [up_to(n) for n in up_to(order)]
    expect(
        rule or said == wanted, f'{words}sent the feedback {said}, expected all numbers so far: {wanted}.', 'feedback'
    )
    expect(heard == due, f'{words}sent feedback after {heard} s, expected after {due} s.', rule or 'count')


@pytest.mark.rules('names', 'orders', 'count', 'feedback', 'succeeds', 'rejected', 'cancel')
@about('count')
def test_one_goal(learner):
    """A goal counts to its order, one number every 0.5 s; orders below 1 are rejected; a goal can be cancelled.

    This part is like exercise 5.1.
    """
    draw = learner.random
    space, order = draw.choice(['/left', '/shop/door']), draw.randint(3, 5)
    node = learner.start('NewestWins', threads=True, remap={'__ns': space})
    expect(
        node.name == f'{space}/newest_wins', f'Your node is called {node.name}, expected {space}/newest_wins.', 'names'
    )
    client = learner.action_client(f'{space}/count', Fibonacci)
    learner.run(draw.choice([0.2, 1.35]))
    expect(
        client.name in client.theirs(),
        f'Your node {node.name} has no action server {client.name}: write the name without a leading slash.',
        'names',
    )
    for number in (order, 1):
        goal = client.send(order=number)
        learner.run(number / 2 + 0.7)
        check_goal(goal)
    check_long(learner, client, draw.randint(51, 60))
    goal = client.send(order=4)
    learner.run(0.7)
    bad = [client.send(order=number) for number in (0, -1, -draw.randint(2, 2**31))]
    learner.run(2.0)
    for other in bad:
        expect(other.accepted is False, f'The order {other.request.order} was accepted.', 'orders')
    check_goal(goal, 'Goals came in the meantime that were rejected. ', 'rejected')
    late = draw.randint(12, 30)
    steps = [(draw.randint(48, 2**31 - 1), 0), (9, 1), (9, draw.choice([2, 3])), (9, draw.randint(4, 7)), (40, late)]
    draw.shuffle(steps)
    for number, count in [*steps, (3, 2)]:  # at last, in the last step
        check_cancel(learner, client, number, count, 0.5 * count + 0.2)


def check_long(learner, client, order) -> None:
    """Expect that a goal of a large order counts to its end, too, and tells each number."""
    goal = client.send(order=order)
    learner.run(order / 2 + 0.7, step=0.5)
    _expect_accepted(goal)
    said = [list(feedback.sequence) for feedback in goal.feedback]
    expect(
        goal.status == 'succeeded' and numbers(goal) == up_to(order),
        f'{order / 2} s after a goal of order {order} its status is {goal.status}, and it has {len(numbers(goal))} '
        f'numbers, expected succeeded with {order}.',
        'count',
    )
    expect(
        len(said) == order,
        f'A goal of order {order} sent {len(said)} feedback messages, expected one for each number.',
        'feedback',
    )
    wrong = next((n for n, heard in enumerate(said, 1) if heard != up_to(n)), None)
    expect(
        wrong is None,
        f'A goal of order {order}: the feedback number {wrong} is {said[(wrong or 1) - 1]}, expected all numbers so '
        f'far, {up_to(wrong or 1)}.',
        'feedback',
    )


def _expect_accepted(goal) -> None:
    order = goal.request.order
    expect(goal.accepted, f'The goal of order {order} {goal.answer}. Every order from 1 is accepted.', 'orders')


def check_cancel(learner, client, order, count, seconds) -> None:
    """Expect that a goal that is cancelled after so many seconds, with `count` numbers, ends so."""
    goal = client.send(order=order)
    learner.run(seconds, step=0.5)
    _expect_accepted(goal)
    words = f'A goal of order {order} was cancelled {seconds:.1f} s after its start. '
    with about('cancel'):
        cancel = goal.cancel()
        learner.run(0.5)
    expect(
        cancel.answer == 'accepted',
        f'{words}The cancel request was answered: {cancel.answer or "not at all"}.',
        'cancel',
    )
    expect(
        goal.status == 'canceled',
        f'{words}0.5 s later it is {goal.status or "still running"}, expected canceled.{goal.why_aborted}',
        'cancel',
    )
    expect(numbers(goal) == up_to(count), f'{words}The result is {numbers(goal)}, expected {up_to(count)}.', 'cancel')


@pytest.mark.rules('newest', 'stops', 'aborted')
@about('newest')
def test_newest_wins(learner):
    """A second goal ends the first one: aborted within 0.5 s, with the numbers it had; the second counts for itself.

    Remember the newest goal in handle_accepted_callback; the loop of an older one sees that it is not the newest.
    """
    draw = learner.random
    client = learner.action_client('/count', Fibonacci)
    learner.start('NewestWins', threads=True)
    same = draw.randint(3, 4)
    for order, count, newer in (
        (draw.randint(21, 2**31 - 1), draw.randint(1, 3), draw.randint(3, 4)),
        (draw.randint(41, 2**31 - 1), draw.randint(12, 30), 1),  # late
        (4, 3, draw.randint(5, 6)),  # in its last step, by a larger one
        (same, 0, same),  # before its first number, by one that asks for the same
    ):
        check_replaced(learner, client, order, count, newer)
    goal = client.send(order=2)
    learner.run(1.5)
    check_goal(goal, 'A goal came when nothing ran any more, after one had been aborted. ', 'newest')
    check_own_results(learner, client)
    several = [client.send(order=2) for _ in range(3)]
    learner.run(2.0)
    ends = [goal.status for goal in several]
    expect(
        ends[:2] == ['aborted', 'aborted'],
        f'Three goals came at one moment; they ended as {ends}, expected the first two aborted.',
        'aborted',
    )
    check_goal(several[2], 'Three goals came at one moment. The last of them: ', 'newest')
    for pause, words in ((0.6, 'had been cancelled'), (0.1, 'had been cancelled, and before that one had ended')):
        goal = client.send(order=5)
        learner.run(0.7)
        goal.cancel()
        learner.run(pause)
        goal = client.send(order=2)
        learner.run(1.5)
        check_goal(goal, f'A goal came after another one {words}. ', 'newest')


@pytest.mark.rules('orders', 'count', 'newest', 'stops', 'aborted', 'rejected', 'cancel')
@about('newest')
def test_goals_at_any_time(learner):
    """Whenever goals come, replace each other and are cancelled: each counts until its end, and ends as the card says.

    Each goal looks for itself, after each wait, whether it was cancelled and whether it is still the newest.
    """
    check_script(learner, 12)


@pytest.mark.rules('newest')
@about('newest')
def test_two_servers(learner):
    """Two objects of your class in one program: a goal of one does not end the goal of the other.

    Keep the newest goal in an attribute of self, and in no variable of the class or of the module.
    """
    check_two_servers(learner)


def check_two_servers(learner) -> None:
    """Two servers of one process have one name: each of them hears the same goal, and counts for it."""
    client = learner.action_client('/count', Fibonacci)
    node = learner.start('NewestWins', threads=True)
    order = learner.random.randint(2, 3)
    alone = client.send(order=order)
    learner.run(5.0, until=lambda: alone.done)
    if alone.finished is None:
        return  # other tests look at one server
    node.stop()  # what one object keeps from goal to goal is judged by other tests
    node = learner.start('NewestWins', threads=True)
    learner.start('NewestWins', threads=True, beside=node)
    goal = client.send(order=order)
    learner.run(alone.finished - alone.sent + 0.2)
    heard, wanted = len(goal.feedback), 2 * len(alone.feedback)
    expect(
        heard == wanted,
        f'Two objects of your class ran in one program, and both heard of one goal of order {order}. {heard} feedback '
        f'messages came, expected {wanted}, half of them from each object: a goal of one object must not stop a goal '
        'of the other one. Keep the newest goal in self, and in no variable of the class or of the module.',
        'newest',
    )


@pytest.mark.rules('newest', 'aborted', 'cancel')
@about('newest')
def test_threads(learner):
    """Of two goals that come at one moment the second is the newest, whichever thread is the first to go on.

    handle_accepted_callback is called in the order of the goals; two execute callbacks may begin in any order.
    """
    check_threads(learner)


def check_threads(learner) -> None:
    """Two goals come at one moment, while the thread of the first stands aside at one place after the other."""
    client = learner.action_client('/count', Fibonacci)
    node = learner.start('NewestWins', threads=True, switches=True)
    for place in range(1, MOST_PLACES):
        node.switch(place)
        first, second = client.send(order=1), client.send(order=1)
        learner.settle()
        places, stood = node.switch(0)
        learner.run(0.6, step=0.5)
        words = (
            f'Two goals came at one moment{stood and f", while a thread stood before {stood}"}; they ended as '
            f'{first.status} and {second.status}, expected aborted and succeeded. '
        )
        expect(
            second.status == 'succeeded',
            f'{words}Note the newest goal in handle_accepted_callback, not when its execute callback begins.',
            'newest',
        )
        expect(first.status == 'aborted', words, 'aborted')
        expect(
            (numbers(first), numbers(second)) == ([], [1]),
            f'{words}Their results are {numbers(first)} and {numbers(second)}, expected [] and [1]: keep the numbers '
            'of a goal in a variable of its execute, and make a new Result there.',
            'newest',
        )
        if places < place:
            break
    _check_cancelled(learner, client, node)
    _check_end(learner, client, node)


def _check_cancelled(learner, client, node) -> None:
    """Of two goals of one moment the newer one is cancelled, and ends while the thread of the other stands aside."""
    for place in range(1, PLACES_AT_LOOK):
        first, second = client.send(order=3), client.send(order=3)
        learner.run(0.2)
        second.cancel()
        learner.settle()
        node.switch(place)
        learner.run(0.5, step=0.5)
        _, stood = node.switch(0)
        learner.run(1.5, step=0.5)
        words = (
            'Two goals of order 3 came at one moment, and 0.2 s later the second one was cancelled'
            f'{stood and f", while a thread stood before {stood}"}; they ended as {first.status or "nothing yet"} with '
            f'{numbers(first)} and {second.status or "nothing yet"} with {numbers(second)}, expected aborted and '
            'canceled, both with []. '
        )
        expect(
            (first.status, numbers(first)) == ('aborted', []),
            f'{words}A goal that a newer one has replaced ends, whatever becomes of the newer one.',
            'newest',
        )
        expect((second.status, numbers(second)) == ('canceled', []), words, 'cancel')


def _check_end(learner, client, node) -> None:
    """A goal comes while the thread of the one before it stands aside somewhere in its last step."""
    for place in range(learner.random.randint(1, 2), MOST_PLACES, 2):  # a look and the change after it have several
        first = client.send(order=1)
        learner.run(0.3)
        node.switch(place, hold=True)
        learner.run(0.2)
        second = client.send(order=1)
        learner.settle()
        _, stood = node.switch(0)
        learner.settle()
        learner.run(0.6, step=0.5)
        words = f'A goal came in the last step of another one{stood and f", whose thread stood before {stood}"}'
        expect(
            second.status == 'succeeded' and numbers(second) == [1],
            f'{words}; 0.6 s later it is {second.status or "still running"}, with {numbers(second)}, expected '
            'succeeded with [1]. A goal that ends leaves alone what was noted of a newer one.',
            'newest',
        )
        expect(first.status in ('succeeded', 'aborted'), f'{words}, and that one {first.ended}.', 'newest')
        if not stood:  # its last step has fewer places
            break


def check_replaced(learner, client, order, count, newer) -> None:
    """Expect that a goal of this order, with `count` numbers, gives way to one of the order `newer`."""
    begin = 0.5 * count + learner.random.choice([0.1, 0.2, 0.3])
    old = client.send(order=order)
    learner.run(begin, step=0.5)
    _expect_accepted(old)
    new = client.send(order=newer)
    with about('aborted'):  # what the old goal does at its end
        learner.run(0.5)
    words = f'A goal of order {order}, and {begin:.1f} s after it one of order {newer}: '
    expect(new.accepted, f'{words}the second goal {new.answer}. The newest goal wins.', 'newest')
    expect(
        old.done or new.feedback,
        f'{words}0.5 s later the first goal goes on, and the second one has not begun: it begins at once.',
        'newest',
    )
    expect(old.done, f'{words}the first goal goes on beside the second one.', 'aborted')
    expect(
        len(old.feedback) <= count and len(numbers(old)) <= count,
        f'{words}the first goal had {up_to(count)} when the second one came; then it went on, with '
        f'{len(old.feedback)} feedback messages and the result {numbers(old)}.',
        'stops',
    )
    expect(
        old.status == 'aborted',
        f'{words}the first goal {old.ended}, expected aborted: a newer one has taken its place.',
        'aborted',
    )
    expect(
        numbers(old) == up_to(count),
        f'{words}the result of the first goal is {numbers(old)}, expected what it had, {up_to(count)}.',
        'aborted',
    )
    learner.run(0.5 * newer + 0.3)
    check_goal(new, words, 'newest')
