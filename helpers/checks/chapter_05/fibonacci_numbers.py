"""The numbers of exercise 5.1, what the feedback of its longest goal is, and that each goal has a result of its own."""

from helpers.checks.chapter_05.kept_results import check_kept
from helpers.runner import expect

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
