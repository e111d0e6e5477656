"""What a server has kept as the results of its goals: for exercises 5.1, 5.3, 5.4 and 5.5."""

from collections.abc import Callable

from helpers.runner import expect
from helpers.runner.action_peers import Goal

ENOUGH = 12  # goals, of which a test asks for the result once more


def check_kept(learner, goals: list[Goal], told: Callable[[Goal], str], shown: Callable, rule: str) -> None:
    """Ask for the results of goals that have ended once more: what other goals did since then has changed none of them.

    rclpy keeps the Result object that execute has returned, not a copy of it.

    :param goals: in the order in which they were sent; those that have not ended, or were rejected, are left out.
    :param told: gives what a goal is called in the message, such as 'goal A'.
    :param shown: gives what its Result says there.
    :param rule: that is broken if a result has changed.
    """
    ended = [goal for goal in goals if goal.finished is not None]
    for goal in ended[:ENOUGH]:
        again = goal.ask_again()
        learner.settle()
        if again.status != goal.status or again.result == goal.result:
            continue  # the server may keep no results, or not for long
        by = next((other for other in ended if other.finished > goal.finished and other.result == again.result), None)
        when = f'{told(by)} had ended' if by else 'other goals had ended'
        expect(
            False,
            f'The result of {told(goal)} was {shown(goal.result)}. When {when}, a client asked for it once more, '
            f'and it was {shown(again.result)}. rclpy keeps the Result that execute returns, and gives it to everybody '
            'who asks later: make a new Result in each execute.',
            rule,
        )
