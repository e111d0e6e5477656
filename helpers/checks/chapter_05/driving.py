"""In which order a driver of exercises 5.4 and 8.9 stops the robot and ends its goal."""

import pytest

from helpers.runner import expect
from helpers.runner.action_peers import Goal

ENDS = ('succeeded', 'canceled', 'aborted')


def check_order(commands, goal: Goal, story: str, rule: str = 'zeros') -> None:
    """The last of `commands`, which stops the robot, was published before the end of the goal: this rule.

    Both are said at one moment of simulated time, so what counts is when they were published.
    """
    ended = [at for status, at in zip(goal.statuses, goal.published, strict=True) if status in ENDS]
    expect(
        not ended or commands.published[-1] < ended[0],
        f'{story}the zeros were published only after the goal had ended. Stop the robot first, and then end the goal: '
        'who hears of the end must find a robot that stands.',
        rule,
    )


def check_newest(commands: list, wanted: tuple[float, float], story: str) -> None:
    """Of the `commands` since a pose came, already the first one is what steer gives for it, `wanted`: rule `steer`."""
    first = commands[0].linear.x, commands[0].angular.z
    last = commands[-1].linear.x, commands[-1].angular.z
    expect(
        first == pytest.approx(wanted, abs=0.01) or last != pytest.approx(wanted, abs=0.01),
        f'{story}. The first command after this pose is {first}, as for an older pose, and the last one {last}: after '
        'the wait, take the pose that is the newest then.',
        'steer',
    )
