"""What the tests of exercise 6.5 show the learner's node: two turtles, the second one steered by it."""

import math
import random
from itertools import pairwise

import numpy as np
from geometry_msgs.msg import Twist

from helpers.checks.chapter_06.frame_comparisons import origin, same
from helpers.runner import expect
from helpers.runner.frames import pose
from helpers.runner.peers import SECOND
from helpers.show.turtle_view import STEP, World

STEPS = 8  # of the simulation between two transforms: 0.128 s
LONG = 11.0  # s: longer than a buffer keeps
NEAR = 0.011  # s: how exactly a command keeps its time
HEIGHT = 0.7  # m, of the leader's frame above the follower's: chase does not ask for it


class Pursuit:
    """Turtles `leader` and `me` in the real turtle simulation, in simulated time; their frames are in `world`.

    Places are x, y, theta: metres and radians.
    """

    def __init__(self, learner, leader, me, first=(5.5, 5.5, 0.0), second=(2.0, 2.0, 0.0), **start):
        """The clock is far from 0, as every clock is: `now - 0.5 s` is a time, too. Half seconds have ticks."""
        learner.now = round((learner.random.randint(1000, 1900) + 0.8) * SECOND)
        self.learner, self.names = learner, (leader, me)
        self.begin = learner.now / SECOND
        self._world = World(random_source=random.Random(0))
        self.leader = self._world.spawn(*first, leader)
        self.me = self._world.spawn(*second, me)
        self.commands = learner.listen(f'/{me}/cmd_vel', Twist)
        self._tf = learner.tf_broadcaster()
        self.stamps = {leader: 0.0, me: 0.0}  # simulated seconds: the newest that each has sent
        self.node = learner.start('Follower', leader, me, **start)
        expect(
            learner.slept == 0.0,
            f'Your constructor waits ({learner.slept:.2g} s). A transform comes when it comes: make the listener, and '
            'look it up in the timer.',
            'no-wait',
        )

    @property
    def distance(self) -> float:
        """Metres from one turtle to the other."""
        return math.dist((self.leader.x, self.leader.y), (self.me.x, self.me.y))

    @property
    def stands(self) -> bool:
        """Whether the last command stops the follower; fails if there is none."""
        expect(self.commands.messages, f'No command came on /{self.names[1]}/cmd_vel.')
        return zeros(self.commands.messages[-1])

    def place(self) -> np.ndarray:
        """Where the leader is in the frame of the follower: x, y, z."""
        return origin(np.linalg.inv(self._pose(self.me)) @ self._pose(self.leader))

    def _pose(self, turtle) -> np.ndarray:
        """The matrix of a turtle in the world."""
        return pose(turtle.x, turtle.y, HEIGHT if turtle is self.leader else 0.0, yaw=turtle.theta)

    def tell(self, names=None, seconds: float | None = None) -> None:
        """Turtles (both, unless named) say where they are; stamped now, or as given (simulated seconds)."""
        for turtle in (self.leader, self.me):
            if names is None or turtle.name in names:
                self._tf.send('world', turtle.name, self._pose(turtle), seconds)
                stamp = self.learner.now / SECOND if seconds is None else seconds
                self.stamps[turtle.name] = max(stamp, self.stamps[turtle.name])

    def tell_elsewhere(self, name: str) -> None:
        """A turtle says where it is in another tree, whose root is `map`: no way leads from one to the other."""
        self._tf.send('map', name, pose(1.0, 2.0))

    def seen_back(self) -> np.ndarray:
        """Where the follower is in the frame of the leader: x, y, z."""
        return origin(np.linalg.inv(self._pose(self.leader)) @ self._pose(self.me))

    def in_space(self) -> np.ndarray:
        """A place in the direction of the leader that is as far in the plane as the leader is in space: x, y."""
        place = self.place()
        return place[:2] * np.linalg.norm(place) / max(np.linalg.norm(place[:2]), 1e-9)

    def is_for(self, command: Twist, x: float, y: float) -> bool:
        """Whether a command is what `chase` says for this place."""
        wanted = self.learner.call('chase', float(x), float(y))
        return same((command.linear.x, command.angular.z), (wanted.linear.x, wanted.angular.z), 1e-3)

    def run(self, seconds: float, names=None, delay: float = 0.0, drive=(0.0, 0.0)) -> None:
        """Let time pass while turtles say where they are, `delay` seconds late.

        :param drive: the leader's speeds: metres and radians in a second.
        """
        pending = []
        end = self.learner.now / SECOND + seconds
        while (now := self.learner.now / SECOND) < end - 1e-9:
            for turtle in (self.leader, self.me):
                if names is None or turtle.name in names:
                    pending.append((now, turtle.name, self._pose(turtle)))
            while pending and pending[0][0] <= now - delay + 1e-9:
                stamp, name, matrix = pending.pop(0)
                self._tf.send('world', name, matrix, stamp)
            seen = len(self.commands)
            self.learner.run(STEPS * STEP, step=STEPS * STEP)
            for command in self.commands.messages[seen:]:
                if all(map(math.isfinite, (command.linear.x, command.angular.z))):
                    self.me.command(now, command.linear.x, command.angular.z)
            self.leader.command(now, *drive)
            for step in range(1, STEPS + 1):
                self._world.step(now + step * STEP)


def gaps(there: Pursuit, begin: int = 0, end: int | None = None) -> list[float]:
    """The seconds from each of these commands to the next."""
    return [later - earlier for earlier, later in pairwise(there.commands.stamps[begin:end])]


def check_first(there: Pursuit) -> None:
    """The first command that was heard is the first one of its publisher, and comes from the timer: rule `rate`."""
    at_once = there.commands.stamps[0] < there.begin + NEAR  # on a busy machine it is heard
    expect(
        there.commands.numbers[0] == 1 and not at_once,
        'A command went out in the constructor. Publish in the timer only: one command every 0.1 s, and no others.',
        'rate',
    )


def check_gaps(there: Pursuit, begin: int, story: str) -> None:
    """From the command with this number on, none came less than 0.1 s after the one before it: rule `rate`."""
    odd = [gap for gap in gaps(there, max(0, begin - 1)) if gap < 0.1 - NEAR]
    expect(
        not odd,
        f'{story}, and two commands came {min(odd, default=0.0):.2f} s one after the other; expected one every 0.1 s, '
        'and no others.',
        'rate',
    )


def check_places(there: Pursuit) -> None:
    """The command is what `chase` says, wherever the leader is: near and far, on all sides. Rule `place`."""
    draw = there.learner.random
    places = [
        (draw.uniform(0.2, 0.9), draw.uniform(-3.0, 3.0)),  # so near that it stands
        (draw.uniform(1.05, 1.3), draw.uniform(-0.9, 0.9)),
        (draw.uniform(1.004, 1.012), draw.uniform(-0.9, 0.9)),  # it hardly drives
        (draw.uniform(1.5, 4.0), draw.choice([-1, 1]) * draw.uniform(0.002, 0.006)),  # it hardly turns
        (draw.uniform(1.5, 4.0), draw.choice([-1, 1]) * draw.uniform(0.02, 0.06)),
        (draw.uniform(9.0, 12.0), draw.uniform(-0.3, 0.3)),
        (draw.uniform(30.0, 60.0), draw.uniform(-0.3, 0.3)),
        (draw.uniform(1.5, 4.0), draw.uniform(1.2, 2.6)),
        (draw.uniform(4.5, 7.0), draw.uniform(2.7, 3.1)),
        (draw.uniform(1.5, 4.0), draw.uniform(-3.1, -1.2)),
    ]
    draw.shuffle(places)
    for distance, angle in [*places, (2.0, 0.6)]:  # there it drives again
        there.me.theta = draw.uniform(-3.0, 3.0)
        direction = there.me.theta + angle
        there.leader.x = there.me.x + distance * math.cos(direction)
        there.leader.y = there.me.y + distance * math.sin(direction)
        there.tell()
        there.learner.run(0.1)
        command, (x, y, _) = there.commands.messages[-1], there.place()
        wanted = there.learner.call('chase', float(x), float(y))
        expect(
            there.is_for(command, x, y) and _other_parts(command) == _other_parts(wanted),
            f'The leader is {distance:.3f} m away, {angle:.3f} rad to the left, at ({x:.3f}, {y:.3f}) in the frame '
            f'`{there.names[1]}`. The command is {_told(command)}, and chase says {_told(wanted)}.',
            'place',
        )


def _other_parts(command: Twist) -> tuple[float, ...]:
    """All speeds but those that `chase` sets."""
    linear, angular = command.linear, command.angular
    return linear.y, linear.z, angular.x, angular.y


def _told(command: Twist) -> str:
    return f'linear.x {command.linear.x:.3f}, angular.z {command.angular.z:.3f}'


def check_long_silence(there: Pursuit) -> None:
    """Both turtles say nothing any more, for longer than a buffer keeps: every command is zeros. Rule `old`."""
    begin = there.learner.now / SECOND
    there.learner.run(0.7)  # so that what they said last is too old
    count = len(there.commands)
    there.learner.run(LONG, step=1.0)
    _check_steady(there, count)
    commands = zip(there.commands.stamps[count:], there.commands.messages[count:], strict=True)
    drives = [stamp - begin for stamp, command in commands if not zeros(command)]
    expect(
        not drives,
        f'Both turtles said nothing for {min(drives, default=0.0):.1f} s, and the command drives: the older transforms '
        f'are, the less they are worth.{_moving(there.commands.messages[count:])}',
        'old',
    )


def _check_steady(there: Pursuit, begin: int) -> None:
    """In the last `LONG` seconds nobody spoke, and commands came to the end, from number `begin` on: rule `old`."""
    count, wanted = len(there.commands) - begin, round(LONG / 0.1)
    last = LONG - (there.learner.now / SECOND - there.commands.stamps[-1])
    expect(
        count >= wanted - 2,  # whether there are too many is for `check_gaps` to say
        f'Both turtles said nothing for {LONG:g} s, and in this time {count} commands came, the last one after '
        f'{last:.1f} s; expected one every 0.1 s, zeros, too, however long it takes.',
        'old',
    )


def check_lost_again(there: Pursuit) -> None:
    """For a while one turtle is in another tree, so tf2 no longer knows the transform: rules `unknown` and `again`.

    Before, the follower drives.
    """
    lost, other = there.learner.random.sample(there.names, 2)
    there.tell_elsewhere(lost)
    there.learner.run(0.05)  # so that no command is of the moment in which it is said
    count = len(there.commands)
    for _ in range(4):
        there.tell([other])
        there.learner.run(0.1)
    who = 'leader' if lost == there.names[0] else 'follower'
    story = f'tf2 knew the transform; then the {who} was in another tree for 0.4 s, and no way led to it'
    commands = there.commands.messages[count:]
    expect(len(commands) >= 3, f'{story}. In this time only {len(commands)} commands came.', 'unknown')
    expect(all(map(zeros, commands)), f'{story}. A command drives all the same.{_moving(commands)}', 'unknown')
    for _ in range(3):
        there.tell()
        there.learner.run(0.1)
    expect(not there.stands, f'{story}. The transforms have come again, and the follower still stands.', 'again')


def check_limit(there: Pursuit) -> None:
    """A transform that is 0.5 s old to the nanosecond is not older than that: rule `old`.

    The times are full and half seconds, so that answers which count in seconds have them exactly, too.
    """
    learner, half = there.learner, SECOND // 2
    learner.run(0.6)
    tick = (learner.now // half + 1) * half
    there.tell(seconds=(tick - half) / SECOND)
    learner.run((tick - learner.now) / SECOND)
    check_gaps(there, 1, 'Transforms were some tenths of a second old')
    for stamp, command in zip(there.commands.stamps, there.commands.messages, strict=True):
        expect(
            stamp != tick / SECOND or not zeros(command),
            f'At {stamp:.1f} s, the newest transforms had the stamp {stamp - 0.5:.1f} s, so they were exactly 0.5 s '
            'old, and the command is zeros. What is older than 0.5 s is too old; 0.5 s is not.',
            'old',
        )
    there.tell(seconds=learner.now / SECOND + 0.9)
    learner.run(0.15)
    expect(
        not there.stands,
        'The newest transforms have a stamp that is later than the time of the clock, as those of a machine whose '
        'clock is a little fast. The command is zeros: what is new is not older than 0.5 s.',
        'old',
    )
    _check_two(there)


def _check_two(there: Pursuit) -> None:
    """Another follower in the same program leaves this one its frames: rule `place`."""
    alone = _count_for_a_while(there)
    there.learner.start('Follower', 'nobody', 'somebody', beside=there.node)
    for _ in range(2):
        there.learner.run(0.3)
        there.tell()
    there.learner.run(0.15)
    leader, me = there.names
    count = _count_for_a_while(there)
    expect(
        0 < count < 2 * alone,  # with another period than 0.1 s it may be one more, or less
        f"Another Follower('nobody', 'somebody') was made in the same program. Then {count} commands came on "
        f'/{me}/cmd_vel in 0.4 s, and before it was made {alone}. The publisher and the timer belong to the object '
        '(self).',
        'topic',
    )
    expect(
        not there.stands,
        f"Another Follower('nobody', 'somebody') was made in the same program, and Follower({leader!r}, {me!r}) "
        'stands. The names of the frames belong to the object (self).',
        'place',
    )


def _count_for_a_while(there: Pursuit) -> int:
    """How many commands come in 0.4 s, in which the places are told again and again."""
    before = len(there.commands)
    for _ in range(4):
        there.tell()
        there.learner.run(0.1)
    return len(there.commands) - before


def _moving(commands: list[Twist]) -> str:
    """The first of these commands that moves the robot, for a message."""
    first = next((command for command in commands if not zeros(command)), Twist())
    return f' It is linear.x {first.linear.x:.2f} and angular.z {first.angular.z:.2f}: both must be zero.'


def zeros(command: Twist) -> bool:
    """Whether a command stops the robot."""
    return (command.linear.x, command.angular.z) == (0.0, 0.0)


def check_topic(there: Pursuit) -> None:
    """Fail unless the follower has its publisher, with the depth 10."""
    leader, me = there.names
    topic = f'/{me}/cmd_vel'
    expect(
        there.learner.endpoints(topic).publishers, f'Follower({leader!r}, {me!r}) has no publisher on {topic}.', 'topic'
    )
    depths = there.learner.depths('publisher', topic)
    expect(depths == [10], f'Your publisher on {topic} has the depth {depths[0]}, expected 10.', 'topic')
