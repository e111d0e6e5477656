"""Hidden tests of exercise 5.4, drive to a place."""

import math

import pytest
from geometry_msgs.msg import Twist
from turtle_interfaces.action import DriveTo
from turtlesim.msg import Pose

from helpers.checks.chapter_05.driving import (
    check_cancel,
    check_corners,
    check_feedback_now,
    check_last_feedback,
    check_newest,
    check_old_pose,
    check_order,
    check_outside,
    check_own_results,
    check_time,
    check_two_drivers,
    check_walls,
    longest_pause,
)
from helpers.runner import about, expect
from helpers.runner.turtlesim import TurtleSim

pytestmark = [pytest.mark.exercise('5.4'), pytest.mark.wiring(type='names', namespace='names')]


def begin(learner, x=5.5, y=5.5, theta=0.0):
    client = learner.action_client('/drive_to', DriveTo)
    sim = TurtleSim(learner, x, y, theta)
    node = learner.start('Driver', threads=True)
    sim.run(0.2)
    return client, sim, node


def stands(sim) -> bool:
    """Whether the last command was one of zeros."""
    last = sim.commands.messages[-1]
    return (last.linear.x, last.angular.z) == (0.0, 0.0)


@pytest.mark.weight(3)
@pytest.mark.rules('arrive', 'names', 'next', 'result', 'zeros')
@about('arrive')
def test_arrive(learner):
    """The turtle arrives, within 0.1 m, from wherever it stands and looks, and stops there.

    Use steer() with the newest pose, not with the first one; at the end publish a Twist of zeros.
    """
    draw = learner.random
    client, sim, node = begin(learner, draw.uniform(4, 7), draw.uniform(4, 7), draw.uniform(-3, 3))
    expect(node.name == '/driver', f'Your node is called {node.name}, expected /driver.', 'names')
    for number in range(2):
        angle, length = draw.uniform(-3, 3), draw.uniform(0.8, 1.8)
        x, y = sim.turtle.x + length * math.cos(angle), sim.turtle.y + length * math.sin(angle)
        goal = client.send(x=x, y=y)
        sim.run(6.0, until=lambda: goal.done)  # noqa: B023 - used within the round
        expect(goal.accepted, f'Goal {number + 1}, ({x:.1f}, {y:.1f}), was rejected.', 'next')
        expect(
            goal.status == 'succeeded',
            f'The goal ({x:.1f}, {y:.1f}) {goal.ended}, expected succeeded within 6 s.',
            'arrive',
        )
        distance = sim.distance(x, y)
        expect(
            distance < 0.15,
            f'The goal succeeded when the turtle was {distance:.2f} m from the place, expected less than 0.1 m.',
            'arrive',
        )
        expect(
            goal.result.distance == pytest.approx(distance, abs=0.1) and 0 < goal.result.distance < 0.1,
            f'The distance in the result is {goal.result.distance:.3f} m; the turtle was {distance:.3f} m away.',
            'result',
        )
        expect(stands(sim), 'The goal succeeded, but the last command still drives. Publish a Twist of zeros.', 'zeros')
        check_order(sim.commands, goal, 'The goal succeeded: ')
    check_own_results(learner, client)


@pytest.mark.weight(2)
@pytest.mark.rules('feedback')
@about('feedback')
def test_feedback(learner):
    """Feedback tells the distance, 2 to 5 times a second, while the turtle drives.

    Not in every round of a fast loop: feedback is for people and for slow decisions.
    """
    client, sim, _ = begin(learner, 1.0, 1.0)
    goal = client.send(x=10.0, y=learner.random.uniform(1, 3))
    truth = []  # (time, true distance)
    begun = learner.now / 1e9
    for _ in range(20):
        sim.run(0.1)  # or a bit more: until the next pose is due
        truth.append((learner.now / 1e9, sim.distance(goal.request.x, goal.request.y)))
    rate = len(goal.feedback) / (learner.now / 1e9 - begun)
    expect(goal.feedback, 'No feedback came.')
    expect(rate <= 5.6, f'{rate:.1f} feedback messages came in a second, expected at most 5: do not flood.')
    expect(rate >= 1.9, f'{rate:.1f} feedback messages came in a second, expected at least 2.')
    pause = longest_pause(goal, learner.now / 1e9)
    expect(pause < 0.65, f'For {pause:.1f} s no feedback came while the turtle drove.')
    told = [feedback.distance for feedback in goal.feedback]
    expect(
        told == sorted(told, reverse=True), 'The turtle comes nearer, but the distance in the feedback does not fall.'
    )
    # The last feedback may be half a second old: it is compared with where the turtle was when it came.
    _, then = min(truth, key=lambda moment: abs(moment[0] - goal.stamps[-1]))
    expect(
        abs(told[-1] - then) < 0.5,
        f'The last feedback says {told[-1]:.2f} m, and the turtle was {then:.2f} m away: use the newest pose.',
    )


@pytest.mark.weight(2)
@pytest.mark.rules('cancel', 'zeros', 'result', 'next')
@about('cancel')
def test_cancel(learner):
    """A cancelled goal ends within 0.2 s; the turtle stops and stays; the result has the distance that is left.

    Look at is_cancel_requested in each round; publish zeros before canceled().
    """
    client, sim, _ = begin(learner, 10.9, 1.0, math.pi)  # at the right wall, looking away from it
    goal = client.send(x=1.0, y=1.0)
    sim.run(learner.random.uniform(0.4, 0.8))
    cancel = goal.cancel()
    sim.run(0.3)
    expect(
        cancel.done,
        'The cancel request was not answered while the turtle drove: no thread was free to hear it.',
        'cancel',
    )
    expect(cancel.answer == 'accepted', 'The cancel request was refused.', 'cancel')
    expect(
        goal.status == 'canceled',
        f'0.3 s after the cancel request the goal is {goal.status or "still running"}, expected canceled.',
        'cancel',
    )
    expect(
        stands(sim), 'After the goal was cancelled, the last command still drives. Publish a Twist of zeros.', 'zeros'
    )
    left = sim.distance(1.0, 1.0)
    expect(
        goal.result.distance == pytest.approx(left, abs=0.6),
        f'The distance in the result is {goal.result.distance:.2f} m, and {left:.2f} m were left.',
        'result',
    )
    count = len(sim.commands)
    sim.run(0.3)
    expect(len(sim.commands) == count, 'Commands came after the goal had ended.', 'zeros')
    zeros = [command for command in sim.commands.messages if not command.linear.x and not command.angular.z]
    expect(len(zeros) == 1, f'{len(zeros)} commands of zeros came at the end of a goal, expected one.', 'zeros')
    check_order(sim.commands, goal, 'The goal was cancelled: ')
    again = client.send(x=sim.turtle.x, y=1.5)
    sim.run(4.0, until=lambda: again.done)
    expect(
        again.status == 'succeeded',
        f'After a cancelled goal, the next one ended as {again.status or "rejected"}.',
        'next',
    )


@pytest.mark.rules('field', 'next')
@about('field')
def test_outside(learner):
    """Places outside of 0 … 11 are rejected; the corners are not.

    Both x and y, on both sides.
    """
    client, _, _ = begin(learner)
    near = learner.random.uniform(0.001, 0.05)
    for x, y in (
        (-near, 5.0),
        (5.0, -near),
        (5.0, -learner.random.uniform(0.1, 9)),
        (11 + near, 5.0),
        (5.0, 11 + near),
        (5.0, math.nan),
        (math.nan, 5.0),
    ):
        goal = client.send(x=x, y=y)
        learner.settle()
        expect(goal.accepted is False, f'The goal ({x:g}, {y:g}) was accepted.', 'field')
    check_corners(learner, client)


@pytest.mark.rules('busy', 'arrive')
@about('busy')
def test_one_at_a_time(learner):
    """While one goal runs, others are rejected, and the turtle goes on to the first place.

    Two goals must not fight for one motor. Note in the goal callback that the robot is taken.
    """
    client, sim, _ = begin(learner)
    other = learner.action_client('/drive_to', DriveTo)
    first, second = client.send(x=7.0, y=5.5), other.send(x=1.0, y=1.0)
    sim.run(0.5)
    third = other.send(x=2.0, y=9.0)
    learner.settle()
    if third.accepted is False:
        check_outside(learner, other)
    sim.run(5.0, until=lambda: first.done)
    expect(
        [first.accepted, second.accepted, third.accepted] == [True, False, False],
        'Two goals came at one moment, and one more while the turtle drove; '
        f'{[first.accepted, second.accepted, third.accepted].count(True)} were accepted, expected the first only.',
        'busy',
    )
    expect(first.status == 'succeeded', f'The first goal {first.ended}, expected succeeded.', 'arrive')
    far = sim.distance(7.0, 5.5)
    expect(
        far < 1.0,  # it stood at (5.5, 5.5); the places of the others lie far behind
        f'The goal (7, 5.5) succeeded {far:.1f} m away from it: the robot went to a place of a goal that was rejected.',
        'busy',
    )
    expect(far < 0.2, f'The goal (7, 5.5) succeeded {far:.1f} m away from it, expected less than 0.1 m.', 'arrive')


@pytest.mark.rules('cancel', 'feedback', 'arrive', 'give-up')
@about('cancel')
def test_near_and_late(learner):
    """Also near its place, and long after its start, a goal gives feedback and can be cancelled.

    Each round does the same, however many there were.
    """
    client = learner.action_client('/drive_to', DriveTo)
    poses = learner.talk('/turtle1/pose', Pose)
    learner.start('Driver', threads=True)
    poses.send(Pose(x=4.0, y=4.0))
    learner.settle()
    distance, seconds = learner.random.uniform(0.15, 0.3), learner.random.uniform(11.0, 18.0)
    goal = client.send(x=4.0 + distance, y=4.0)
    learner.run(seconds)
    expect(
        goal.status != 'aborted',
        f'The turtle was {distance:.2f} m away from the place, and the goal was given up within {seconds:.1f} s, '
        'expected after 20 s.',
        'give-up',
    )
    expect(
        not goal.done,
        f'The turtle was {distance:.2f} m away from the place, and the goal {goal.ended}: it arrives when '
        'the distance is below 0.1 m.',
        'arrive',
    )
    pause = longest_pause(goal, learner.now / 1e9)
    expect(pause < 0.65, f'For {pause:.1f} s no feedback came: the turtle was {distance:.2f} m away.', 'feedback')
    check_cancel(learner, client, goal, f'A goal was cancelled {seconds:.1f} s after its start: ')


@pytest.mark.rules('busy', 'give-up', 'cancel', 'next', 'feedback', 'zeros', 'no-pose')
@about('busy')
def test_cancelled_before(learner):
    """Until a cancelled goal has ended, no other one is accepted; the next one has its 20 s, and feedback in each.

    What belongs to one goal begins anew with the next one.
    """
    client = learner.action_client('/drive_to', DriveTo)
    poses = learner.talk('/turtle1/pose', Pose)
    node = learner.start('Driver', threads=True)
    poses.send(Pose(x=2.0, y=2.0))
    learner.settle()
    goal = client.send(x=9.0, y=2.0)
    # Soon after a half of a second: who looks in each fifth round only, is late.
    seconds = round(learner.random.randint(4, 7) / 2 + learner.random.choice([0.1, 0.2]), 1)
    learner.run(seconds)
    check_cancel(learner, client, goal, f'A goal was cancelled {seconds:g} s after its start: ')
    goal = client.send(x=9.0, y=2.0)
    learner.run(1.0)
    y = learner.random.uniform(3.0, 5.0)
    poses.send(Pose(x=2.0, y=y, theta=learner.random.uniform(1.0, 2.0), linear_velocity=1.0))
    learner.run(17.5)
    expect(goal.accepted, 'A goal that came after a cancelled one was rejected.', 'next')
    pause = longest_pause(goal, goal.finished or learner.now / 1e9)
    expect(pause < 0.65 and len(goal.stamps) > 35, 'For a while no feedback came: the turtle only turned.', 'feedback')
    told, left = goal.feedback[-1].distance, math.hypot(7.0, y - 2.0)
    expect(
        told == pytest.approx(left, abs=0.01),
        f'The turtle is {left:.2f} m away from the place, and the feedback says {told:.2f}.',
        'feedback',
    )
    check_feedback_now(learner, goal, poses)
    near = learner.random.uniform(0.12, 0.9)
    poses.send(Pose(x=9.0 - 0.6 * near, y=2.0 + 0.8 * near))
    learner.run(1.4)  # 0.8 s before its end and longer: time for feedback that comes twice a second
    expect(goal.done, 'After 20.6 s the goal still runs.', 'give-up')
    expect(
        goal.status == 'aborted',
        f'After 20 s the turtle was {near:.2f} m away from the place: the goal {goal.ended}, expected aborted.',
        'give-up',
    )
    took = goal.finished - goal.sent
    expect(
        took == pytest.approx(20.0, abs=0.5),
        f'A goal that came after one that had been cancelled after {seconds:g} s was given up after {took:.1f} s, '
        'expected 20 s: each goal has 20 s of its own.',
        'give-up',
    )
    check_last_feedback(goal, 'A goal was given up: ', near)
    check_old_pose(learner, client)
    check_walls(learner, client, poses)
    poses.send(Pose(x=8.0, y=2.0))
    learner.settle()
    commands = learner.listen('/turtle1/cmd_vel', Twist)
    learner.run(0.2)
    _end_before_a_move(learner, client, commands)
    check_two_drivers(learner, node, client, poses, commands)


def _end_before_a_move(learner, client, commands):
    """Zeros come before every end, also if the turtle, at (8, 2), has not moved for the goal."""
    for x, seconds in ((9.0, 0.05), (8.0, 0.3)):  # cancelled before the first command; there already
        commands.clear()
        goal = client.send(x=x, y=2.0)
        learner.run(seconds, step=0.05)
        goal.cancel()
        learner.run(0.6)
        zeros = [command for command in commands.messages if not command.linear.x and not command.angular.z]
        expect(
            goal.done and len(zeros) == 1,
            f'A goal {goal.ended} before the turtle had moved for it, and {len(zeros)} commands of zeros '
            'came, expected one before every end.',
            'zeros',
        )


@pytest.mark.rules('give-up', 'zeros', 'steer')
@about('give-up')
def test_stuck(learner):
    """A turtle that does not get there is given up after 20 s: zeros, and aborted.

    Count the rounds, or look at the clock. A goal must end.
    """
    client = learner.action_client('/drive_to', DriveTo)
    poses = learner.talk('/turtle1/pose', Pose)
    commands = learner.listen('/turtle1/cmd_vel', Twist)
    learner.start('Driver', threads=True)
    poses.send(Pose(x=2.0, y=2.0))
    learner.settle()
    goal = client.send(x=9.0, y=2.0)
    learner.run(18.0)
    expect(goal.accepted, 'The goal was rejected.', 'give-up')
    expect(175 <= len(commands) <= 182, f'{len(commands)} commands came in 18 s, expected one every 0.1 s.', 'steer')
    expect(
        not goal.done,
        f'The goal {goal.ended} after {goal.finished or 0:g} s, expected to be given up after 20 s.',
        'give-up',
    )
    learner.run(4.0)
    expect(goal.done, 'The turtle did not move for 22 s, and the goal still runs.', 'give-up')
    expect(goal.status == 'aborted', f'The turtle never came near; the goal {goal.ended}, expected aborted.', 'give-up')
    expect(
        goal.finished - goal.sent == pytest.approx(20.0, abs=0.5),
        f'The goal was given up after {goal.finished - goal.sent:g} s, expected 20 s.',
        'give-up',
    )
    last = commands.messages[-1]
    expect(
        (last.linear.x, last.angular.z) == (0.0, 0.0),
        'The goal was given up, but the last command still drives: publish a Twist of zeros.',
        'zeros',
    )
    check_order(commands, goal, 'The goal was given up: ')
    check_time(learner, client, poses)


@pytest.mark.rules('names', 'no-pose', 'steer', 'next', 'arrive')
@about('steer')
def test_poses(learner):
    """In a namespace: before the first pose goals are rejected, and then the newest pose counts.

    Relative names; keep the newest pose in the subscription's callback.
    """
    draw = learner.random
    client = learner.action_client('/two/drive_to', DriveTo)
    poses = learner.talk('/two/turtle1/pose', Pose)
    commands = learner.listen('/two/turtle1/cmd_vel', Twist)
    node = learner.start('Driver', threads=True, remap={'__ns': '/two'})
    expect(node.name == '/two/driver', f'Your node is called {node.name}, expected /two/driver.', 'names')
    learner.settle()
    expect(
        client.name in client.theirs()
        and learner.endpoints('/two/turtle1/pose').subscriptions
        and learner.endpoints('/two/turtle1/cmd_vel').publishers,
        'In the namespace /two not all names are there: leave out the leading slash.',
        'names',
    )
    early = client.send(x=1.0, y=1.0)
    learner.settle()
    expect(early.accepted is False, 'A goal was accepted before a pose had come.', 'no-pose')
    poses.send(Pose(x=1.0, y=1.0))
    learner.settle()
    goal = client.send(x=9.0, y=1.0)
    learner.run(0.5)
    expect(goal.accepted, 'A goal after one that was rejected was rejected, too.', 'next')
    distance = draw.uniform(0.4, 1.2)
    poses.send(Pose(x=9.0 - distance, y=1.0))
    learner.settle()
    commands.clear()
    learner.run(0.3)
    expect(
        commands.messages and commands.messages[-1].linear.x == pytest.approx(1.5 * distance, abs=0.01),
        f'{distance:.2f} m are left, and the last command is not what steer gives for this pose.',
        'steer',
    )
    check_newest(commands.messages, (1.5 * distance, 0.0), f'{distance:.2f} m are left')
    outside, inside = draw.uniform(0.102, 0.106), draw.uniform(0.095, 0.098)
    poses.send(Pose(x=9.0 - outside * math.sqrt(0.5), y=1.0 - outside * math.sqrt(0.5)))
    learner.run(0.3)
    expect(
        not goal.done,
        f'The turtle was {outside:.3f} m from the place, the same way in x and in y; the goal {goal.ended}.',
        'arrive',
    )
    poses.send(Pose(x=9.0 - 0.8 * inside, y=1.0 - 0.6 * inside, linear_velocity=draw.uniform(0.5, 2.0)))  # it moves
    learner.run(0.3)
    expect(
        goal.status == 'succeeded',
        f'The turtle is {inside:.3f} m from the place; 0.3 s later the goal is {goal.status or "still running"}.',
        'arrive',
    )
