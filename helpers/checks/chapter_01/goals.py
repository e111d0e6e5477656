"""Drives of the simulated turtle to a goal: for exercise 1.4."""

import math
from random import Random

from helpers.runner import about, expect
from helpers.runner.turtlesim import TurtleSim

WITHIN = 0.1  # m
AT_MOST = 20.0  # s
DIZZY = 4 * math.pi  # who has turned so much does not find the goal
AWAY = 2.6  # radians: who looks farther away from the goal has nearly the same way round to both sides
BEHIND = 1.7  # radians: who looks so far away from the goal, and is farther from it than NEAR, should only turn
TOWARDS = 0.5  # radians: who looks so near to the goal looks there
ASKEW = 1.0  # radians: who looks so far away from the goal does not look to it, and is slower than most of the time
NEAR = 0.5  # m
NAME, POSE, COMMAND = 'go_to_goal', 'turtle1/pose', 'turtle1/cmd_vel'


class Drive:
    """The learner's node drives the turtle from `start` (x, y, theta) to `goal` (x, y), in a namespace."""

    def __init__(self, learner, start, goal, space: str = ''):
        self.learner, self.start, self.goal, self.space = learner, start, goal, space
        self.sim = TurtleSim(learner, *start, namespace=space)
        with about('reach'):
            self.node = learner.start('GoToGoal', *goal, remap={'__ns': space} if space else None)
        self.way = (
            f'From ({start[0]:.1f}, {start[1]:.1f}), heading {math.degrees(start[2]):.0f}°, '
            f'to ({goal[0]:.1f}, {goal[1]:.1f}): '
        )
        self.goal_beside: tuple[float, float] | None = None  # of another node, whose turtle gets no pose

    def begin_another(self) -> None:
        """A second object of the class, in a namespace and with a goal of its own, is made after this one."""
        places = [self.start[:2], self.goal]
        while len(places) == 2:
            place = self.learner.random.uniform(2.5, 8.5), self.learner.random.uniform(2.5, 8.5)
            if min(math.dist(place, one) for one in places) > 2:
                places.append(place)
        self.goal_beside = places[2]
        with about('reach'):
            space = {'__ns': f'{self.space}/second'}
            self.learner.start('GoToGoal', *self.goal_beside, beside=self.node, remap=space)

    def other_one_drives(self) -> None:
        """That object gets poses now, of a turtle of its own, and comes to its goal, too."""
        goal = self.goal_beside
        if goal is None:
            raise ValueError('there is no other one: call begin_another before')
        sim = TurtleSim(self.learner, *self.start, namespace=f'{self.space}/second')
        with about('reach'):
            sim.run(AT_MOST, until=lambda: sim.distance(*goal) < WITHIN)
        place = f'({sim.turtle.x:.1f}, {sim.turtle.y:.1f})'
        # Who shares something with the other object does not come so near to a goal of its own.
        expect(
            not WITHIN <= sim.distance(*goal) < NEAR,
            f'From ({self.start[0]:.1f}, {self.start[1]:.1f}) to ({goal[0]:.1f}, {goal[1]:.1f}): after {AT_MOST:g} s '
            f'the turtle is {_far(sim.distance(*goal))} away, at {place}. It must come to {WITHIN:g} m of the goal.',
            'reach',
        )
        expect(
            sim.distance(*goal) < WITHIN,
            'A second object of your class, in another namespace, drove its turtle after the first one had come to its '
            f'goal, and after {AT_MOST:g} s was still {sim.distance(*goal):.2f} m away from its own. Keep in self what '
            'the node knows and does: what stands in the class, or outside of it, is the same for all objects.',
            'reach',
        )

    def check_ends(self) -> None:
        """Name, topics and queues are as specified."""
        expect(
            self.node.name == f'{self.space}/{NAME}',
            f'The node is called {self.node.name}, expected {self.space}/{NAME}.',
            'node',
        )
        for kind, name in (('subscription', POSE), ('publisher', COMMAND)):
            topic = f'{self.space}/{name}'
            there = getattr(self.learner.endpoints(topic), f'{kind}s')
            absolute = self.space and getattr(self.learner.endpoints(f'/{name}'), f'{kind}s')
            expect(
                not absolute,
                f'In the namespace {self.space} your {kind} stays on /{name}: a relative name has no '
                'slash at its beginning.',
                'topics',
            )
            expect(there, f'Your node has no {kind} on {name}.', 'topics')
            depths = self.learner.depths(kind, topic)
            expect(
                set(depths) == {10},
                f'The queue of your {kind} on {name} has the depth {depths[0]}, expected 10.',
                'topics',
            )

    def to_the_goal(self, wall_near: bool = False) -> None:
        """The turtle comes to its goal and stands there.

        :param wall_near: it starts beside a wall; where it does not, who runs into one looks in a wrong direction.
        """
        sim = self.sim
        first = self.error()
        nearest, turned, speeds = self._drive()
        self.drives_forwards_only()
        if self.goal_beside is not None:
            x, y = self.goal_beside
            expect(
                sim.distance(x, y) > 0.5,
                f'{self.way}the turtle drove to ({x:.1f}, {y:.1f}), the goal of a second object of your class, which '
                'was made later, in another namespace. Keep the goal in self: what stands in the class, or outside of '
                'it, is the same for all objects.',
                'reach',
            )
        place = f'({sim.turtle.x:.1f}, {sim.turtle.y:.1f}), heading {math.degrees(sim.turtle.theta):.0f}°'
        expect(sim.commands.messages, f'The simulator told its pose, and no command came on {COMMAND}.', 'reach')
        passed = (
            f'{self.way}the turtle came to {nearest:.2f} m of the goal, and drove on. Drive slower when the '
            'goal is near, and stop there.'
        )
        late = nearest > 0.6 or sim.distance(*self.goal) < WITHIN
        self._no_wall(nearest, late, place, wall_near)
        expect(not sim.bumps, passed, 'stop')
        expect(
            sim.turned < DIZZY or sim.distance(*self.start[:2]) > 1,
            f'{self.way}the turtle turns on the spot, round and round. Is the error in radians, and the heading '
            'subtracted?',
            'reach',
        )
        expect(sim.turned < DIZZY or late, passed, 'stop')
        expect(
            sim.turned < DIZZY,
            f'{self.way}the turtle drives around in circles. Drive slower while the direction '
            'is wrong, and near the goal.',
            'reach',
        )
        expect(
            sim.distance(*self.goal) >= WITHIN or sim.turtle.linear < 0.01,
            f'{self.way}the turtle is at the goal and does not stand still.',
            'stop',
        )
        expect(
            sim.distance(*self.goal) < WITHIN,
            f'{self.way}after {AT_MOST:g} s the turtle is {_far(sim.distance(*self.goal))} away, at {place}. It came '
            f'to {_far(nearest)} of the goal, and must come to {WITHIN:g} m and stay.',
            'reach',
        )
        expect(
            abs(first) > AWAY or turned < math.pi,
            f'{self.way}the goal was {math.degrees(abs(first)):.0f}° to the {"left" if first > 0 else "right"}, and '
            f'the turtle turned by {math.degrees(turned):.0f}° until it looked there: the long way round. The angle '
            'jumps at π: bring the difference into −π … π.',
            'short-way',
        )
        self._turned_first(speeds)

    def _no_wall(self, nearest: float, late: bool, place: str, wall_near: bool) -> None:
        """The turtle has run into no wall, unless it had been at the goal before (not `late`)."""
        expect(
            not self.sim.bumps or not late or wall_near,
            f'{self.way}the turtle drove to a wall, at {place}, and came to {nearest:.2f} m of the goal. The direction '
            'is math.atan2(dy, dx), in radians, and the heading is subtracted from it.',
            'reach',
        )
        expect(
            not self.sim.bumps or not late,
            f'{self.way}the turtle ran into a wall at {place}. Turn first; drive when the direction is nearly right.',
            'walls',
        )

    def _drive(self) -> tuple[float, float, list[tuple[float, float]]]:
        """Let it drive until it has arrived, is dizzy or is late.

        Returns how near to its goal it came (m); how far it had turned when it looked there for the first time
        (radians), 0 if it never did; of each moment its speed (m/s), and how far it looked away from a goal that was
        not near (radians).
        """
        sim, nearest, turned, speeds = self.sim, math.inf, [], []

        def arrived():
            nonlocal nearest
            if abs(self.error()) < TOWARDS:
                turned.append(sim.turned)
            nearest = min(nearest, sim.distance(*self.goal))
            speeds.append((sim.turtle.linear, abs(self.error()) if sim.distance(*self.goal) > NEAR else 0.0))
            return sim.turned > DIZZY or sim.distance(*self.goal) < WITHIN and sim.turtle.linear < 0.01

        with about('reach'):
            sim.run(AT_MOST, until=arrived)
        return nearest, min(turned, default=0.0), speeds

    def _turned_first(self, speeds: list[tuple[float, float]]) -> None:
        """`speeds`: how fast the turtle drove (m/s), and how far it looked away from a goal that was not near."""
        astray = max((speed for speed, error in speeds if error > BEHIND), default=0.0)
        expect(
            astray < 0.05,
            f'{self.way}the turtle drove with {astray:.2f} m/s while the goal was behind it, and so away from the '
            'goal. Turn first, and drive when it looks to the goal.',
            'short-way',
        )
        askew = max((speed for speed, error in speeds if error > ASKEW), default=0.0)
        fastest = max((speed for speed, _ in speeds), default=0.0)
        expect(
            askew < max(0.75 * fastest, 0.05),
            f'{self.way}the turtle drove with {askew:.2f} m/s, nearly as fast as ever, while it looked more than '
            f'{math.degrees(ASKEW):.0f}° past the goal. Turn first, and drive when it looks to the goal.',
            'short-way',
        )

    def turns_on_the_spot(self) -> None:
        """The turtle, which looks away from a near goal, does not go away from it, and comes to it."""
        sim, farthest = self.sim, 0.0

        def arrived():
            nonlocal farthest
            farthest = max(farthest, sim.distance(*self.goal))
            return sim.distance(*self.goal) < WITHIN and sim.turtle.linear < 0.01

        first = sim.distance(*self.goal)
        with about('reach'):
            sim.run(AT_MOST, until=arrived)
        self.drives_forwards_only()
        expect(
            farthest < first + 0.02,
            f'{self.way}the goal was {first:.2f} m behind the turtle, which drove until it was {farthest:.2f} m away '
            'from it. Turn first, also if the goal is near, and drive when the turtle looks to the goal.',
            'short-way',
        )
        expect(
            sim.distance(*self.goal) < WITHIN,
            f'{self.way}after {AT_MOST:g} s the turtle is {sim.distance(*self.goal):.2f} m away.',
            'reach',
        )

    def error(self) -> float:
        """How far the goal is to the left of where the turtle looks, in radians; below 0 it is to the right."""
        turtle = self.sim.turtle
        direction = math.atan2(self.goal[1] - turtle.y, self.goal[0] - turtle.x)
        return math.remainder(direction - turtle.theta, 2 * math.pi)

    def drives_forwards_only(self) -> None:
        """No command so far drives the turtle backwards or sideways."""
        commands = self.sim.commands.messages
        back = min((command.linear.x for command in commands), default=0.0)
        expect(
            back > -1e-3,
            f'{self.way}your node told the turtle to drive backwards, linear.x {back:.2f}. Turn to the goal, and drive '
            'forwards.',
            'short-way',
        )
        aside = max((abs(command.linear.y) for command in commands), default=0.0)
        expect(
            aside < 1e-3,
            f'{self.way}your node told the turtle to slide sideways, linear.y {aside:.2f}. It drives forwards only.',
            'short-way',
        )

    def stays(self, seconds: float) -> None:
        """The turtle has been told zero, and does not move any more."""
        with about('stop'):
            self.sim.run(seconds)
        left = self.sim.distance(*self.goal)
        expect(
            left < WITHIN,
            f'{self.way}the turtle was at the goal and left it: after {seconds:g} s more it is '
            f'{left:.2f} m away. Tell it zero, and go on telling it.',
            'stop',
        )
        expect(self.sim.commands.messages, f'{self.way}no command came on {COMMAND}.', 'stop')
        last = self.sim.commands.messages[-1]
        expect(
            abs(last.linear.x) < 1e-3 and abs(last.angular.z) < 1e-3,
            f'{self.way}at the goal, the last command on {COMMAND} was linear.x {last.linear.x:.2f} and angular.z '
            f'{last.angular.z:.2f}. Publish a command of zero there.',
            'stop',
        )


def _far(metres: float) -> str:
    """A distance, in millimetres where centimetres would not show on which side of the limit it is."""
    return f'{metres:.3f} m' if abs(metres - WITHIN) < 0.01 else f'{metres:.2f} m'


def far_places(random: Random):
    """A start and a goal, 4 to 6 m apart and not near a wall."""
    while True:
        start, goal = [(random.uniform(2.5, 8.5), random.uniform(2.5, 8.5)) for _ in range(2)]
        if 4 < math.dist(start, goal) < 6:
            return start, goal


def any_goal(learner, space: str = '', straight: bool = False) -> Drive:
    """From a drawn place and heading to a drawn goal; `straight`: which lies along y, as it does seldom by chance.

    There x is right from the beginning: who looks at one coordinate only is there at once.
    """
    start, goal = far_places(learner.random)
    if straight:
        start, goal = (goal[0], learner.random.uniform(2.5, 3.5)), (goal[0], learner.random.uniform(7.5, 8.5))
    return Drive(learner, (*start, learner.random.uniform(-3.1, 3.1)), goal, space)


def across_pi(learner, side: int) -> None:
    """The heading is just on one side of the angle at which π becomes −π, the goal just on the other (1 or −1)."""
    tilt = learner.random.uniform(0.3, 0.5)
    goal = (8.0 - 4.0 * math.cos(tilt), 5.5 - side * 4.0 * math.sin(tilt))
    drive = Drive(learner, (8.0, 5.5, side * (math.pi - tilt)), goal)
    drive.to_the_goal()
    expect(
        drive.sim.turned < 2 * tilt + 1.5,
        f'{drive.way}the goal was {math.degrees(2 * tilt):.0f}° to the {"left" if side > 0 else "right"}, and the '
        f'turtle turned by {math.degrees(drive.sim.turned):.0f}° in all. The angle jumps at π, and who turns too fast '
        'turns back and forth.',
        'short-way',
    )


def goal_behind(learner, side: int) -> Drive:
    """The turtle looks askew at a wall that is 2 mm away, and the goal is behind it: an arc has no room.

    :param side: 1 if the short way round is to the left, -1 to the right.
    """
    y = learner.random.uniform(4.0, 7.0)
    goal = (6.5, y + learner.random.uniform(-0.02, 0.02))  # along x, where the other coordinate is right at once
    heading = side * learner.random.uniform(0.9, 1.1)
    return Drive(learner, (11.087, y, heading), goal)


def near_behind(learner, far: float) -> Drive:
    """The goal is so far (m) behind the turtle, and no wall is near."""
    start, _ = far_places(learner.random)
    away = learner.random.uniform(-3.1, 3.1)
    goal = start[0] - far * math.cos(away), start[1] - far * math.sin(away)
    heading = away + learner.random.choice([-1, 1]) * learner.random.uniform(0.1, 0.5)
    return Drive(learner, (*start, math.remainder(heading, 2 * math.pi)), goal)


def across_the_world(learner) -> Drive:
    """From near one corner to a place near the opposite one, in whole numbers: who is slow needs more than the time.

    The goal is straight behind the turtle, as it is seldom by chance: it must turn, and not drive backwards.
    """
    low, high = (learner.random.uniform(0.9, 1.1) for _ in range(2))
    start, goal = learner.random.sample([(low, low), (11.0 - high, 11.0 - high)], 2)
    goal = tuple(map(round, goal))  # as a learner types them: a message takes no int where a float belongs
    away = math.atan2(start[1] - goal[1], start[0] - goal[0]) + learner.random.uniform(-0.15, 0.15)
    return Drive(learner, (*start, away), goal)


def there_already(learner) -> Drive:
    """The turtle starts at its goal."""
    goal = learner.random.uniform(2.0, 9.0), learner.random.uniform(2.0, 9.0)
    return Drive(learner, (*goal, learner.random.uniform(1.0, 3.0)), goal)
