"""Visible tests of exercise 5.4, drive to a place."""

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


class StandingRobot:
    """A robot that does not move: the test says where it stands."""

    def __init__(self, learner):
        self.learner, self.space = learner, learner.random.choice(['/left', '/yard/two'])
        self.poses = learner.talk(f'{self.space}/turtle1/pose', Pose)
        self.commands = learner.listen(f'{self.space}/turtle1/cmd_vel', Twist)
        self.client = learner.action_client(f'{self.space}/drive_to', DriveTo)
        self.node = learner.start('Driver', threads=True, remap={'__ns': self.space})

    def stand(self, x, y, theta=0.0):
        """Tell a pose, and forget the commands so far."""
        self.commands.clear()
        draw = self.learner.random  # how fast it moves says nothing of where it is
        speed, turn = draw.uniform(-2, 2), draw.uniform(-2, 2)
        self.poses.send(Pose(x=x, y=y, theta=theta, linear_velocity=speed, angular_velocity=turn))
        self.learner.settle()

    def said(self):
        """Speed and turn of the last command."""
        last = self.commands.messages[-1]
        return last.linear.x, last.angular.z

    def check_end(self, goal, story, distance):
        """Expect one command of zeros at the end, no command after it, and the distance in the result."""
        self.learner.run(0.5)
        check_zeros(self.commands, goal, story)
        expect(
            goal.result.distance == pytest.approx(distance, abs=0.01),
            f'{story}the distance in the result is {goal.result.distance:.3f} m, and {distance:.3f} m were left.',
            'result',
        )
        check_last_feedback(goal, story, distance)


def check_zeros(commands, goal, story):
    zeros = [
        stamp
        for stamp, command in zip(commands.stamps, commands.messages, strict=True)
        if (command.linear.x, command.angular.z) == (0.0, 0.0)
    ]
    expect(zeros, f'{story}the last command still drives: publish a Twist of zeros before the end.', 'zeros')
    expect(commands.stamps[-1] <= goal.finished, f'{story}commands came after the goal had ended.', 'zeros')
    last = commands.messages[-1]
    expect(
        (last.linear.x, last.angular.z) == (0.0, 0.0),
        f'{story}the last command still drives: publish a Twist of zeros before the end.',
        'zeros',
    )
    expect(len(zeros) == 1, f'{story}{len(zeros)} commands of zeros came, expected one.', 'zeros')
    check_order(commands, goal, story)


@pytest.mark.rules(
    'names', 'no-pose', 'busy', 'steer', 'arrive', 'give-up', 'cancel', 'zeros', 'result', 'feedback', 'next'
)
@about('steer')
def test_standing_robot(learner):
    """A robot that does not get there is given up after 20 s; in the meantime other goals are rejected.

    One round every 0.1 s: wait, steer(), look for a reason to end, else publish. Zeros come after the loop.
    """
    draw, robot = learner.random, StandingRobot(learner)
    _check_names(learner, robot)
    goal = _begin_again(learner, robot, _take_first_goal(learner, robot))
    command = _follow_poses(learner, robot)
    _reject_while_busy(learner, robot, command)
    _give_up(learner, robot, goal)
    check_old_pose(learner, robot.client)
    check_walls(learner, robot.client, robot.poses)
    # Another goal was cancelled 1 s after its start: who does not look in each round is late in one of these.
    seconds = draw.sample([0.75, 1.25], 2)
    late = seconds[1] + draw.randint(11, 17)
    _cancel(learner, robot, seconds[0], draw.uniform(0.4, 1.2), draw.uniform(0.0, 0.4), 1)
    _cancel(learner, robot, late, draw.uniform(0.15, 0.3), draw.uniform(10.6, 11.0), -1)
    check_own_results(learner, robot.client)
    check_time(learner, robot.client, robot.poses)
    check_two_drivers(learner, robot.node, robot.client, robot.poses, robot.commands)


def _check_names(learner, robot):
    """The node, its topics and its action are in the namespace."""
    expect(
        robot.node.name == f'{robot.space}/driver',
        f'Your node is called {robot.node.name}, expected {robot.space}/driver.',
        'names',
    )
    learner.run(0.3)
    expect(
        robot.client.name in robot.client.theirs()
        and learner.endpoints(robot.commands.topic).publishers
        and learner.endpoints(robot.poses.topic).subscriptions,
        f'In the namespace {robot.space} your node has not all of drive_to, turtle1/pose and turtle1/cmd_vel in it: '
        'write the names without a leading slash.',
        'names',
    )


def _take_first_goal(learner, robot):
    """Without a pose no goal is accepted; of two goals that come then, one: returns it."""
    with about('no-pose'):
        goal = robot.client.send(x=5.0, y=5.0)
        learner.settle()
    expect(goal.accepted is False, 'No pose had come yet, and a goal was accepted. Where is the robot?', 'no-pose')
    robot.stand(2.0, 2.0)
    goal, second = robot.client.send(x=9.0, y=2.0), robot.client.send(x=1.0, y=1.0)
    learner.settle()
    expect(
        goal.accepted,
        f'A goal was rejected because no pose had come. Then a pose came, and another goal, which {goal.answer}, too. '
        'Does your node keep the pose, in an attribute of self? And did the rejected goal leave something behind?',
        'next',
    )
    expect(
        second.accepted is False,
        'Two goals came at one moment, and both were accepted: note in the goal callback that the robot is taken.',
        'busy',
    )
    learner.run(1.0)
    expect(
        not robot.commands.messages or robot.said() != pytest.approx((0.0, -3 * math.pi), abs=0.01),
        'Two goals came at one moment. The second one, (1, 1), was rejected, and yet the robot turns to it. Take the '
        'place from the goal that you execute.',
        'busy',
    )
    count = len(robot.commands)
    expect(9 <= count <= 11, f'{count} commands came in the first second, expected one every 0.1 s.', 'steer')
    return goal


def _begin_again(learner, robot, goal):
    """The goal is cancelled, and the same place asked for once more: returns that goal, after a second of it."""
    check_cancel(learner, robot.client, goal, 'A goal was cancelled 1 s after its start: ')
    robot.commands.clear()
    goal = robot.client.send(x=9.0, y=2.0)  # no new pose in between: the newest one still holds
    learner.settle()
    expect(
        goal.accepted,
        f'A goal that came after a cancelled one {goal.answer}. At its end a goal sets back that the robot is '
        'taken; the newest pose stays, whatever goals come.',
        'next',
    )
    learner.run(1.0)
    return goal


def _follow_poses(learner, robot):
    """Each command fits the newest pose; returns the last one, as speed and turn."""
    for theta, wanted in ((0.0, (2.0, 0.0)), (math.pi / 2, (0.0, -2 * math.pi)), (-0.25, (2.0, 1.0))):
        robot.stand(2.0, 2.0, theta)
        learner.run(0.3)
        count = len(robot.commands)
        expect(2 <= count <= 4, f'{count} commands came in 0.3 s, expected one every 0.1 s.', 'steer')
        check_newest(robot.commands.messages, wanted, f'The robot stood at (2, 2) and looked to {theta:.2f} rad')
        expect(
            robot.said() == pytest.approx(wanted, abs=0.01),
            f'The robot stood at (2, 2) and looked to {theta:.2f} rad, the place is (9, 2). 0.3 s after this pose '
            f'the command is {robot.said()}, expected what steer gives, {wanted}: use the newest pose.',
            'steer',
        )
    return wanted


def _reject_while_busy(learner, robot, wanted):
    """Another goal is rejected while one runs, and the robot drives on with the command `wanted`."""
    third = robot.client.send(x=2.0, y=8.0)
    learner.run(0.5)
    expect(third.accepted is False, 'A goal was accepted while another one ran.', 'busy')
    check_outside(learner, robot.client)
    learner.run(0.5)
    expect(
        robot.said() == pytest.approx(wanted, abs=0.01),
        f'While a goal ran, another one was rejected, and since then the command is {robot.said()}, expected {wanted} '
        'as before: the first goal goes on. Take the place from the goal that you execute.',
        'busy',
    )


def _give_up(learner, robot, goal):
    """The goal runs with feedback, and is aborted 20 s after its start."""
    learner.run(8.5)
    y = learner.random.choice([0.5, 3.5, 4.5])
    left = math.hypot(7.0, y - 2.0)
    robot.stand(2.0, y, math.pi / 2)  # from now on it has to turn first
    learner.run(7.3)
    _check_runs(goal)
    rate = len(goal.feedback) / 18.7
    expect(
        1.9 <= rate <= 5.1,
        f'{rate:.1f} feedback messages came in a second, expected 2 to 5: it is for people and for slow decisions.',
        'feedback',
    )
    _check_pause(learner, goal, 'also while the robot only turns')
    told = sorted({round(feedback.distance, 2) for feedback in goal.feedback})
    expect(
        told == pytest.approx([7.0, left], abs=0.02),
        f'The robot stood at (2, 2) and then at (2, {y}), so it was 7 m and {left:.2f} m away from (9, 2); the '
        f'feedback says {", ".join(f"{distance:g}" for distance in told[:5])}.',
        'feedback',
    )
    check_feedback_now(learner, goal, robot.poses)
    _check_runs(goal)
    near = learner.random.uniform(0.12, 0.9)
    robot.stand(9.0 - 0.6 * near, 2.0 + 0.8 * near)  # nearly there, and the time is over
    learner.run(1.1)
    expect(goal.done, 'A robot that does not move: the goal still runs after 20.5 s.', 'give-up')
    expect(
        goal.status == 'aborted',
        f'After 20 s a robot was {near:.2f} m away from the place: the goal {goal.ended}, expected aborted.',
        'give-up',
    )
    took = goal.finished - goal.sent
    expect(
        took == pytest.approx(20.0, abs=0.25),
        f'A robot that does not move: the goal ended after {took:g} s, expected 20 s.',
        'give-up',
    )
    robot.check_end(goal, 'After a goal that was given up, ', near)


def _check_runs(goal):
    """The goal, for a robot that does not get there, has not been given up."""
    expect(
        not goal.done,
        f'A robot that does not move: the goal {goal.ended} after {(goal.finished or 0) - goal.sent:.1f} s, '
        'expected 20 s. The goal before it had been cancelled: each goal has 20 s of its own.',
        'give-up',
    )


def _check_pause(learner, goal, when):
    """Since the goal was sent, feedback came often enough."""
    pause = longest_pause(goal, learner.now / 1e9)
    expect(
        pause < 0.65,
        f'For {pause:.1f} s no feedback came while the goal ran, expected 2 to 5 in each second, {when}.',
        'feedback',
    )


def _cancel(learner, robot, seconds, distance, x, way):
    """Cancel a goal of a robot at this x, and let the next one arrive; `way`: 1 if it looks along x, or -1."""
    yaw = 0.0 if way > 0 else math.pi
    story = f'A goal was cancelled {seconds} s after its start: '
    robot.stand(x, 5.0, yaw)
    goal = robot.client.send(x=x + way * distance, y=5.0)
    learner.run(seconds)
    expect(goal.accepted, f'A goal that came after one that was given up {goal.answer}.', 'next')
    _check_pause(learner, goal, 'also near the place')
    expect(
        robot.said() == pytest.approx((1.5 * distance, 0.0), abs=0.01),
        f'The command is {robot.said()}, expected what steer gives.',
        'steer',
    )
    check_cancel(learner, robot.client, goal, story)
    robot.check_end(goal, story, distance)
    robot.stand(x, 5.0, yaw)
    # Just not there, and less than 0.1 m away in x and in y; then just there, and together more than 0.1 m.
    outside, inside = learner.random.uniform(0.102, 0.106), learner.random.uniform(0.095, 0.098)
    goal = robot.client.send(x=x + way * outside * math.sqrt(0.5), y=5.0 + outside * math.sqrt(0.5))
    learner.run(0.5)
    expect(goal.accepted, f'A goal that came after a cancelled one {goal.answer}.', 'next')
    expect(
        not goal.done,
        f'A goal {outside:.3f} m away (the same way in x and in y) {goal.ended}, expected to go on until '
        'the distance is below 0.1 m.',
        'arrive',
    )
    robot.stand(goal.request.x - way * 0.8 * inside, goal.request.y - 0.6 * inside, yaw)
    learner.run(0.3)
    expect(
        goal.status == 'succeeded',
        f'The robot is {inside:.3f} m from the place; 0.3 s later the goal is '
        f'{goal.status or "still running"}, expected succeeded.{goal.why_aborted}',
        'arrive',
    )
    robot.check_end(goal, 'A goal succeeded: ', inside)
    robot.stand(x, 5.0, yaw)
    goal = robot.client.send(x=x, y=5.03)
    learner.run(0.3)
    story = 'A goal came for a place where the robot stands already, 0.03 m away: '
    expect(goal.accepted, f'{story}it {goal.answer}. It arrives in its first round.', 'arrive')
    expect(goal.status == 'succeeded', f'{story}0.3 s later it is {goal.status or "still running"}.', 'arrive')
    learner.run(0.5)
    expect(robot.commands, f'{story}no zeros were published. They come before every end, also then.', 'zeros')
    robot.check_end(goal, story, 0.03)


@pytest.mark.rules('field', 'arrive', 'zeros', 'result', 'next')
@about('arrive')
def test_simulated_robot(learner):
    """The simulated turtle drives to a place and stops there; places outside of the field are rejected.

    x and y must be from 0 to 11. Within 0.1 m publish a Twist of zeros and succeed.
    """
    draw = learner.random
    client = learner.action_client('/drive_to', DriveTo)
    sim = TurtleSim(learner, draw.uniform(4, 6), draw.uniform(4, 6), draw.uniform(-0.5, 0.5))
    learner.start('Driver', threads=True)
    sim.run(0.1)
    near, far = draw.uniform(0.001, 0.05), draw.uniform(0.1, 99)
    outside = ((-near, 5.0), (5.0, -far), (11 + near, 5.0), (5.0, 11 + far), (-far, 5.0), (5.0, -near))
    outside += ((5.0, 11 + near), (math.nan, 5.0), (5.0, math.nan))
    for x, y in outside:
        goal = client.send(x=x, y=y)
        learner.settle()
        expect(goal.accepted is False, f'The goal ({x:g}, {y:g}) was accepted. No turtle can get there.', 'field')
    angle, length = draw.uniform(-0.5, 0.5), draw.uniform(0.7, 1.2)
    x, y = sim.turtle.x + length * math.cos(angle), sim.turtle.y + length * math.sin(angle)
    words = f'From ({sim.turtle.x:.1f}, {sim.turtle.y:.1f}) to ({x:.1f}, {y:.1f}): '
    goal = client.send(x=x, y=y)
    sim.run(5.0, until=lambda: goal.done)
    expect(goal.accepted, f'{words}the goal {goal.answer}, after some that were outside of the field.', 'next')
    expect(
        goal.status == 'succeeded',
        f'{words}the goal is {goal.status or "still running"} after 5 s, expected succeeded.{goal.why_aborted}',
        'arrive',
    )
    near = sim.distance(x, y)
    expect(near < 0.15, f'{words}the goal succeeded {near:.2f} m from the place, expected less than 0.1 m.', 'arrive')
    expect(
        0 < goal.result.distance < 0.1 and abs(goal.result.distance - near) < 0.1,
        f'{words}the distance in the result is {goal.result.distance:.3f} m; the turtle was {near:.3f} m away.',
        'result',
    )
    sim.run(0.3)
    check_zeros(sim.commands, goal, words)
    check_corners(learner, client)
