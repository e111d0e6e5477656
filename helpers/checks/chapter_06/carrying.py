"""What the tests of exercise 6.3 show the learner's node: a robot that drives, and a cup that is carried."""

import math
from random import Random

import numpy as np
from geometry_msgs.msg import PointStamped
from rclpy.time import Time

from helpers.checks.chapter_06.frame_comparisons import apart, explain, origin, same, words
from helpers.runner import about, expect
from helpers.runner.frames import pose
from helpers.runner.peers import SECOND

EARLIER = 0.03  # s: nobody says that cup and robot were seen at one moment


def told(found: object) -> str:
    """What `where_was` gave, for a message."""
    if not isinstance(found, PointStamped):
        return repr(found)
    return f'the point {words((found.point.x, found.point.y, found.point.z))} in `{found.header.frame_id}`'


class CarriedCup:
    """Robot and cup move straight on, and turn evenly: what tf2 interpolates is exact.

    `robot` and `cup` are (x, y, yaw at the begin; metres, radians) and (their changes in a second). The clock itself is
    far from 0.
    """

    def __init__(self, learner, robot, cup):
        self.learner, self._robot, self._cup = learner, np.array(robot, float), np.array(cup, float)
        learner.now = learner.now or learner.random.randint(1000, 1900) * SECOND
        self._begin = learner.now / SECOND
        self._ramp = Random(learner.now).choice([-1, 1]) * 0.3  # rad: the robot is not level
        self._tf = learner.tf_broadcaster()
        self.newest = 0.0  # stamp of the robot's last transform, simulated seconds

    def robot(self, seconds: float) -> np.ndarray:
        """The matrix of base_link in map."""
        x, y, yaw = self._robot[0] + (seconds - self._begin) * self._robot[1]
        return pose(x, y, 0.3, pitch=self._ramp, yaw=yaw)

    def cup(self, seconds: float) -> np.ndarray:
        """The matrix of cup in map."""
        x, y, yaw = self._cup[0] + (seconds - self._begin) * self._cup[1]
        return pose(x, y, 0.9, yaw=yaw)

    def run(self, rounds: int, period: float = 0.2) -> None:
        """Every `period` seconds both say where they are; afterwards `period` has passed since the last time."""
        for _ in range(rounds):
            self.newest = self.learner.now / SECOND
            self._tf.send('map', 'base_link', self.robot(self.newest), self.newest)
            cup = self.newest - EARLIER
            self._tf.send('map', 'cup', self.cup(cup), cup)
            self.learner.run(period, step=period)

    def tell(self, frame: str) -> None:
        """Only `base_link` or `cup` says where it is."""
        place = self.robot if frame == 'base_link' else self.cup
        self._tf.send('map', frame, place(self.learner.now / SECOND))

    def ask_long_ago(self, node) -> None:
        """Half a minute passes; then ask where the cup was some 25 s ago, exactly 30 s ago, and before that."""
        self.run(33, 1.0)
        self._ask_kept(node, round(self.learner.random.uniform(24.0, 29.5), 1))
        self.run(10, 0.1)  # what is newest is so new now that a buffer of 29.5 s has lost what was 30 s ago
        self._ask_kept(node, 30.0)
        self._ask_before_all(node)

    def ask_first(self, node) -> None:
        """Ask a node that has heard everything, and that nobody has asked before."""
        expect(
            node.call('where_was', 1.0) is not None,
            'All transforms had come when where_was was called for the first time, and where_was(1) gave None: the '
            'buffer and its listener belong into the constructor, so that they hear what comes before the first '
            'question.',
            'none',
        )
        self.ask(node, 1.0)

    def ask_now(self, node) -> None:
        """The cup says where it is now; then ask where it was no time ago, and just before."""
        self.tell('cup')
        self.learner.settle()
        for seconds in (0.0, round(self.learner.random.uniform(0.02, 0.09), 3)):
            expect(
                node.call('where_was', seconds) is not None,
                f'The cup has just said where it is, and where_was({seconds:g}) gave None: {seconds:g} is a number of '
                'seconds like any other.',
                'then',
            )
            self.ask(node, seconds)

    def ask_too_early(self, node) -> None:
        """Ask for a time of which nobody has spoken yet: no other time may take its place. Rule `then`."""
        seconds = round(self.learner.random.uniform(0.03, 0.12), 3)
        found, then = node.call('where_was', seconds), self.learner.now / SECOND - seconds
        if not isinstance(found, PointStamped):
            return
        expected = origin(np.linalg.inv(self.robot(self.newest)) @ self.cup(then))
        expect(
            same((found.point.x, found.point.y, found.point.z), expected, 1e-3),
            f'The newest transform of the cup is for {self.newest - EARLIER:g} s, and where_was({seconds:g}) at time '
            f'{self.learner.now / SECOND:g} s gave {told(found)}. So late a transform of the cup has not come yet, and '
            'where it was before is another place. Do not take another time instead: give None.',
            'then',
        )

    def ask_quiet_robot(self, node) -> None:
        """Only the cup goes on saying where it is; the robot's newest transform is older than the time asked for."""
        for _ in range(12):
            self.tell('cup')
            self.learner.run(0.2, step=0.2)
        seconds = round(self.learner.random.uniform(0.5, 1.4), 2)
        expect(
            node.call('where_was', seconds) is not None,
            f'The robot has said nothing for {self.learner.now / SECOND - self.newest:.1f} s, the cup goes on, and '
            f'where_was({seconds:g}) gave None. For the robot take the newest transform there is, however old it is.',
            'robot-now',
        )
        self.ask(node, seconds)

    def _ask_kept(self, node, seconds: float) -> None:
        expect(
            node.call('where_was', seconds) is not None,
            f'where_was({seconds:g}) gave None, and where_was of some seconds gave a point. How long does a buffer '
            'keep what it hears? 10 s, unless you tell it otherwise; 30 s are wanted.',
            'far',
        )
        self.ask(node, seconds)

    def _ask_before_all(self, node) -> None:
        """Ask for a time, more than half a minute ago, before anything was said: rule `too-long`."""
        past = self.learner.now / SECOND - self._begin
        seconds = round(past + self.learner.random.uniform(5, 90), 1)
        with about('too-long'):
            found = node.call('where_was', seconds)
        expect(
            found is None,
            f'The first transforms came {past:.0f} s ago, and where_was({seconds:g}) gave {told(found)}, expected '
            'None: nobody knows. Do not take another time instead.',
            'too-long',
        )

    def ask(self, node, seconds: float) -> None:
        """Ask the node where the cup was so many seconds ago, and fail with the reason if it is wrong."""
        now = self.learner.now / SECOND
        then, call = now - seconds, f'where_was({seconds:g}) at time {now:g} s'
        found = node.call('where_was', seconds)
        expect(
            found is not None,
            f'{call} gave None. tf2 knows the cup for {then:g} s and the robot for '
            f'{self.newest:g} s, not yet for {now:g} s. The newest transform has the time 0 in a look-up, and the time '
            'of the cup is in the past: the clock of the node, less the seconds. Does every way through the function '
            'return the point? Are the names of the frames those of the card? And is there one buffer, with one '
            'listener, for the life of the node?',
            'robot-now',
        )
        expect(isinstance(found, PointStamped), f'{call} gave {found}, expected a PointStamped.', 'point')
        place = (found.point.x, found.point.y, found.point.z)
        expected = origin(np.linalg.inv(self.robot(self.newest)) @ self.cup(then))
        is_at, wanted = apart(place, expected)
        wrong = [(rule, reason) for other, rule, reason in self._others(now, seconds) if same(place, other, 1e-3)]
        explain(
            same(place, expected, 1e-3),
            f'{call} gave {is_at}, expected {wanted}.'
            + ('' if wrong else ' Is the time that of the clock of the node?'),
            *[(True, reason) for _, reason in wrong],
            rule=(*[rule for rule, _ in wrong], 'then')[0],
        )
        expect(
            found.header.frame_id == 'base_link',
            f'The point has the frame_id `{found.header.frame_id}`, expected `base_link`.',
            'point',
        )
        stamp = Time.from_msg(found.header.stamp).nanoseconds / SECOND
        expect(
            same(stamp, self.newest),
            f"{call} has the stamp {stamp:g} s, expected {self.newest:g} s: that of the robot's newest transform.",
            'stamp',
        )

    def _others(self, now: float, seconds: float) -> list[tuple[np.ndarray, str, str]]:
        """Wrong places of the cup that have a reason: each with the rule that is broken, and with the reason."""
        then, both = now - seconds, self.newest - EARLIER  # the latter is the newest time of which all is known
        robot, before, earlier = (np.linalg.inv(self.robot(at)) for at in (self.newest, then, both))
        x, y, yaw = self._robot[0] + (self.newest - self._begin) * self._robot[1]
        level, whole = np.linalg.inv(pose(x, y, 0.3, yaw=yaw)), math.floor(seconds)
        there = self.cup(then)
        places = [
            (before @ there, 'robot-now', 'This is seen from the robot as it stood then. It has moved on.'),
            (
                before @ self.cup(both),
                'then',
                'This is where the cup was just now, seen from the robot as it stood then: the two times are '
                'exchanged.',
            ),
            (robot @ self.cup(both), 'then', 'This is where the cup was just now.'),
            (earlier @ self.cup(both), 'then', 'This is where the cup was just now.'),
            (
                earlier @ there,
                'robot-now',
                'This is seen from the robot as it stood at the newest time of which tf2 knows the cup, too. There is '
                'a newer transform of the robot.',
            ),
            (
                robot @ self.cup(now - whole),
                'then',
                f'This is where the cup was {whole} s ago: parts of a second count, too.',
            ),
            (
                robot @ self.cup(self.newest - seconds),
                'then',
                "The seconds count back from the time of the node's clock, not from the newest transform.",
            ),
            (
                pose(*origin(robot @ there)[:2]),
                'point',
                'x and y are right, and z is 0: the cup is higher than the robot.',
            ),
            (there, 'point', 'This is in the frame map.'),
            (
                np.linalg.inv(pose(x, y, 0.3)) @ there,
                'point',
                'This is the way from the robot to the cup along the axes of the map. Seen from the robot, ahead is '
                'where it looks.',
            ),
            (level @ there, 'point', 'The robot stands on a ramp: it is turned by more than its yaw.'),
            (
                np.linalg.inv(robot @ there),
                'then',
                'This is where the robot is, seen from the cup: target and source are swapped.',
            ),
        ]
        return [(origin(matrix), rule, reason) for matrix, rule, reason in places]
