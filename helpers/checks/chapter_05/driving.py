"""In which order a driver of exercise 5.4 stops the robot and ends its goal."""

from helpers.runner import expect
from helpers.runner.action_peers import Goal

ENDS = ('succeeded', 'canceled', 'aborted')


def check_order(commands, goal: Goal, story: str) -> None:
    """The last of `commands`, which stops the robot, was published before the end of the goal: rule `zeros`.

    Both are said at one moment of simulated time, so what counts is when they were published.
    """
    ended = [at for status, at in zip(goal.statuses, goal.published, strict=True) if status in ENDS]
    expect(
        not ended or commands.published[-1] < ended[0],
        f'{story}the zeros were published only after the goal had ended. Stop the robot first, and then end the goal: '
        'who hears of the end must find a robot that stands.',
        'zeros',
    )
