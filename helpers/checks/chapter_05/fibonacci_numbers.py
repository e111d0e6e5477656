"""The numbers of exercise 5.1, what the feedback of its longest goal is, and that each goal has a result of its own."""

from example_interfaces.action import Fibonacci

from helpers.checks.chapter_05.kept_results import check_kept
from helpers.runner import expect

MOST_PLACES = 92  # in the learner's lines, to which threads come in one step of two goals

SERIES = [0, 1]
while len(SERIES) < 47:
    SERIES.append(SERIES[-1] + SERIES[-2])


def check_longest_feedback(goal) -> None:
    """Expect that a goal of order 47, which has ended, had one feedback with all numbers so far for each number."""
    heard = [list(feedback.sequence) for feedback in goal.feedback]
    for count, said in enumerate(heard[:47], 1):
        expect(
            said == SERIES[:count],
            f'Order 47: when {count} numbers were there, the feedback had {len(said)}: … {said[-3:]}. Expected all '
            f'numbers so far, {count}: … {SERIES[max(0, count - 3) : count]}.',
            'feedback',
        )
    expect(
        len(heard) == 47,
        f'Order 47: {len(heard)} feedback messages came for 47 numbers, expected one for each number.',
        'feedback',
    )
    took = [round(stamp - goal.sent, 3) for stamp in goal.stamps]
    late = next((count for count, stamp in enumerate(took, 1) if stamp != count / 2), None)
    expect(
        late is None,
        f'Order 47: number {late} came {took[(late or 1) - 1]} s after the goal, expected after {(late or 1) / 2} s: '
        "one number every 0.5 s of the node's clock.",
        'rate',
    )


def check_own_results(learner, goals) -> None:
    """Expect that each of these goals, which have ended, has a result of its own: rule `goals`."""
    check_kept(
        learner,
        goals,
        lambda goal: f'the goal of order {goal.request.order}',
        lambda result: list(result.sequence),
        'goals',
    )


def check_threads(learner) -> None:
    """Two goals make their steps at the same moments, while a thread stands aside at one place after the other.

    What one of them has put into an object that both share, the other one changes before it is sent: rule `goals`.
    """
    client = learner.action_client('/fibonacci', Fibonacci)
    node = learner.start('FibonacciServer', threads=True, switches=True)
    alone = client.send(order=2)
    learner.run(1.5, step=0.5)
    expect(alone.accepted, f'The goal of order 2 {alone.answer}. It can be done.', 'orders')
    if _heard(alone) != [SERIES[:1], SERIES[:2]]:
        return  # other tests judge a goal that is alone
    place, places = 0, 1  # first without a thread that stands aside: what is wrong then has another cause
    while place <= min(places, MOST_PLACES):
        goals = [client.send(order=47)]
        learner.run(0.5)
        goals.append(client.send(order=46))
        for _ in range(46):
            node.switch(place)
            learner.run(0.5, step=0.5)
            came, stood = node.switch(0)
            places = max(came, 1)
            for goal in goals:
                _check_last(goal, stood)
            place += 1
            if place > min(places, MOST_PLACES):
                break
        for goal in goals:
            goal.cancel()
        learner.run(1.0, step=0.5)


def _check_last(goal, stood: str) -> None:
    """Expect that the newest feedback of a goal has its own numbers; `stood`: where a thread of the program stood."""
    heard = _heard(goal)
    count = len(heard)
    expect(
        heard[-1:] == [SERIES[:count]],
        'Two goals made a step at the same moment'
        f'{stood and f", while the thread of one stood before {stood}"}. Feedback {count} of the goal of order '
        f'{goal.request.order} was then {heard[-1] if heard else "missing"}, expected its own numbers so far, '
        f'{SERIES[:count]}. Make a new Feedback in execute, and keep all that belongs to one goal in variables there.',
        'goals',
    )


def _heard(goal) -> list[list[int]]:
    return [list(feedback.sequence) for feedback in goal.feedback]
