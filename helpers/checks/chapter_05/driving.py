"""How a driver of exercises 5.4 and 8.9 ends its goal, which pose it uses, and what is its own."""

import math
from itertools import pairwise

import pytest
from turtlesim.msg import Pose

from helpers.checks.chapter_05.kept_results import check_kept
from helpers.runner import about, expect
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


def check_cancel(learner, client, goal: Goal, story: str) -> None:
    """Cancel a goal: it ends within 0.2 s as canceled, and until its end no other goal is accepted."""
    with about('cancel'):
        cancel = goal.cancel()
        learner.settle()
        running = not goal.done
        other = client.send(x=5.0, y=6.0) if running else None
        learner.settle()
        running = running and not goal.done
        learner.run(0.2)
    expect(cancel.done, f'{story}the cancel request was not answered: no thread was free to hear it.', 'cancel')
    expect(cancel.answer == 'accepted', f'{story}the cancel request was refused.', 'cancel')
    expect(
        goal.status == 'canceled',
        f'{story}0.2 s later it is {goal.status or "still running"}, expected canceled.{goal.why_aborted}',
        'cancel',
    )
    expect(
        not running or not other.accepted,
        f'{story}directly after the cancel request, when it still ran, another goal came and was accepted. The robot '
        'is free when the goal has ended, not when somebody has asked for its end.',
        'busy',
    )


def check_outside(learner, client) -> None:
    """While a goal runs, one outside of the field is rejected, and the robot stays taken: rule `busy`."""
    x, y = learner.random.choice([(12.0, 5.0), (5.0, -1.0)])
    client.send(x=x, y=y)
    learner.settle()
    goal = client.send(x=5.0, y=5.0)
    learner.settle()
    expect(
        not goal.accepted,
        f'While a goal ran, one outside of the field came, ({x:g}, {y:g}), and then one for (5, 5), which was '
        'accepted. A goal that is rejected changes nothing: only the end of the goal that runs sets the robot free.',
        'busy',
    )


def check_walls(learner, client, poses) -> None:
    """Where a coordinate of the robot is exactly 0.0 its pose is a pose, too: rule `no-pose`.

    No goal runs, and with the pose so far a goal would have been accepted.
    """
    for x, y in ((0.0, learner.random.uniform(1, 9)), (learner.random.uniform(1, 9), 0.0), (0.0, 0.0)):
        poses.send(Pose(x=x, y=y))
        learner.settle()
        goal = client.send(x=5.0, y=5.0)
        learner.settle()
        expect(
            goal.accepted,
            f'The robot stands at ({x:.4g}, {y:.4g}), at the wall, and a goal {goal.answer}. A coordinate 0.0 counts '
            'as False: ask "is None", to see whether a pose has come.',
            'no-pose',
        )
        _cancel_at_once(learner, goal)


def check_time(learner, client, poses) -> None:
    """A goal succeeds, and another one is given up; the next one has 20 s all the same, each time: rule `give-up`."""
    seconds = learner.random.choice([2.0, 3.5, 5.0])
    poses.send(Pose(x=2.0, y=2.0))
    learner.settle()
    goal = client.send(x=9.0, y=2.0)
    learner.run(seconds)
    poses.send(Pose(x=9.0, y=2.0))
    learner.run(0.3)
    poses.send(Pose(x=2.0, y=2.0))
    learner.settle()
    following = client.send(x=9.0, y=2.0)
    learner.run(19.5, step=0.5)
    if goal.status != 'succeeded':
        return  # other tests look at that
    story = f'A goal {goal.ended} {seconds:g} s after its start. The next one, for a robot that does not move, '
    expect(following.accepted, f'{story}{following.answer}.', 'next')
    expect(not following.done, f'{story}{_after(following)}, expected 20 s: each goal has 20 s of its own.', 'give-up')
    learner.run(1.0)
    expect(following.status == 'aborted', f'{story}{_after(following)}, expected aborted after 20 s.', 'give-up')
    third = client.send(x=9.0, y=2.0)
    learner.run(19.5, step=0.5)
    story = 'A goal was given up after 20 s. The next one, for a robot that does not move, '
    expect(third.accepted, f'{story}{third.answer}.', 'next')
    expect(not third.done, f'{story}{_after(third)}, expected 20 s: each goal has 20 s of its own.', 'give-up')
    third.cancel()
    learner.run(0.3)


def _after(goal: Goal) -> str:
    return f'{goal.ended} after {goal.finished - goal.sent:.1f} s' if goal.finished else 'has not ended after 20.5 s'


def check_own_results(learner, client) -> None:
    """Expect that each goal of this client that has ended has a result of its own: rule `result`."""
    check_kept(
        learner,
        client.goals,
        lambda goal: f'the goal ({goal.request.x:.2f}, {goal.request.y:.2f}), {goal.status},',
        lambda result: f'{result.distance:.3f} m',
        'result',
    )


def longest_pause(goal: Goal, end: float) -> float:
    """Return the longest time without feedback, in s, from the sending of the goal to `end`, a time in s."""
    moments = [goal.sent, *goal.stamps, end]
    return max(late - early for early, late in pairwise(moments))


def check_feedback_now(learner, goal: Goal, poses) -> None:
    """While the goal runs, a new pose comes in each round: feedback is for the newest (rule `feedback`).

    It takes 0.7 s, in which there is feedback.
    """
    place = goal.request
    for number in range(7):
        x, y = place.x - 6.0 + 0.4 * number, place.y + 0.3 * number
        distance, count = math.hypot(place.x - x, place.y - y), len(goal.feedback)
        poses.send(Pose(x=x, y=y))
        learner.run(0.1)
        for feedback in goal.feedback[count:]:
            expect(
                feedback.distance == pytest.approx(distance, abs=0.02),
                f'The robot was {distance:.2f} m away from ({place.x:g}, {place.y:g}), and the feedback in the next '
                f'round says {feedback.distance:.2f} m: a pose came before it. Tell the distance that steer gives in '
                'this round, not one of the round before.',
                'feedback',
            )


def check_last_feedback(goal: Goal, story: str, distance: float) -> None:
    """What feedback told at last, if there was any, is the distance at the end, in m (rule `feedback`).

    The robot stood there for the last rounds; before, it was at most 2 cm away from there.
    """
    last = goal.feedback[-1].distance if goal.feedback else distance
    expect(
        last == pytest.approx(distance, abs=0.02),
        f'{story}the last feedback says {last:.3f} m, and the robot was {distance:.3f} m away: also at the end '
        'feedback tells the distance.',
        'feedback',
    )


def check_old_pose(learner, client) -> None:
    """A goal was given up, and 10 s later the newest pose still says where the robot stands: rule `next`."""
    learner.run(10.0, step=1.0)
    goal = client.send(x=9.0, y=2.0)
    learner.settle()
    expect(
        goal.accepted,
        f'A goal that came after one that was given up {goal.answer}. At its end a goal sets back that the robot is '
        'taken; and the newest pose holds, however old it is.',
        'next',
    )
    _cancel_at_once(learner, goal)


def _cancel_at_once(learner, goal: Goal) -> None:
    """Cancel a goal that has just been accepted: it ends within 0.2 s as canceled (rule `cancel`)."""
    cancel = goal.cancel()
    learner.run(0.3)
    expect(
        cancel.answer == 'accepted' and goal.status == 'canceled',
        f'A goal was cancelled at the moment when it came; 0.3 s later the request is {cancel.answer or "not answered"}'
        f', and the goal is {goal.status or "still running"}, expected canceled within 0.2 s.{goal.why_aborted}',
        'cancel',
    )


def check_two_drivers(learner, node, client, poses, commands) -> None:
    """A second object of the class in the process of `node` knows no pose yet; then it drives while the first one does.

    The first one knows a pose, and has no goal. Both are in one namespace, so both hear of each goal.
    """
    learner.start('Driver', threads=True, beside=node)
    for drivers, rule, story in (
        (1, 'no-pose', 'A pose had come before the second one was there, so only the first one could take a goal'),
        (2, 'busy', 'The first one had a goal when another one came, which the second one could take'),
    ):
        client.send(x=9.0, y=2.0)
        learner.settle()
        commands.clear()
        learner.run(1.0)
        count = len(commands)
        expect(
            abs(count - 10 * drivers) <= drivers,
            f'Two objects of your class ran in one program, both for one robot. {story}. {count} commands came in a '
            f'second, expected {10 * drivers}. Keep the pose, and whether the robot is taken, in attributes of self, '
            'and in no variable of the class or of the module.',
            rule,
        )
        poses.send(Pose(x=2.0, y=2.0))
        learner.settle()


def check_corners(learner, client) -> None:
    """The field goes from 0 to 11, both included: a goal in a corner is accepted (rule `field`).

    The second corner is asked for only if the first goal has ended.
    """
    for x, y in ((11.0, 0.0), (0.0, 11.0)):
        goal = client.send(x=x, y=y)
        learner.settle()
        expect(
            goal.accepted,
            f'The goal ({x:g}, {y:g}) {goal.answer}. It is a corner of the field. Do goals before it leave something '
            'behind?',
            'field',
        )
        goal.cancel()
        learner.run(0.3)
        if not goal.done:  # the rule `cancel`, which other tests judge
            return
