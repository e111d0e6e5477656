"""turtlesim for tests: the real simulation, in the test's process and in simulated time.

`TurtleSim` stands in for the node of the simulator: the learner's program gets poses and steers by velocity commands.
"""

import math
import random
from collections.abc import Callable

from geometry_msgs.msg import Twist
from turtlesim.msg import Pose

from helpers.show.turtle_view import STEP, World

# The simulator tells its pose after each step of 16 ms. Here it does so as often as the motion needs, which saves time:
FAR, TURN = 0.05, 0.15  # metres and radians from one pose to the next, about
FEWEST, MOST = 2, 8  # steps from one pose to the next


class TurtleSim:
    """One turtle, `turtle1`. `turtle` is where it is; `bumps` counts the walls it ran into; `turned` is in radians.

    :param x, y, theta: where it begins, in metres and radians.
    :param namespace: of the topics, such as ``/sim2``.
    """

    def __init__(self, learner, x: float, y: float, theta: float, namespace: str = ''):
        self._learner = learner
        self._world = World(random_source=random.Random(0))
        self.turtle = self._world.spawn(x, y, theta, 'turtle1')
        self.bumps = 0
        self.turned = 0.0
        self.now = 0.0
        self.commands = learner.listen(f'{namespace}/turtle1/cmd_vel', Twist)
        self._poses = learner.talk(f'{namespace}/turtle1/pose', Pose)

    def distance(self, x: float, y: float) -> float:
        """Metres from the turtle to a place."""
        return math.dist((self.turtle.x, self.turtle.y), (x, y))

    def run(self, seconds: float, until: Callable[[], bool] = lambda: False) -> bool:
        """Let simulated time pass, until the condition holds after a pose; returns whether it did. A wall ends it."""
        end = self.now + seconds
        while self.now < end and not self.bumps:
            turtle = self.turtle
            steps = self._steps()
            self._poses.send(
                Pose(
                    x=turtle.x,
                    y=turtle.y,
                    theta=turtle.theta,
                    linear_velocity=turtle.linear,
                    angular_velocity=turtle.angular,
                )
            )
            seen = len(self.commands)
            self._learner.run(steps * STEP, step=steps * STEP)  # the pose is answered first, at this moment
            for command in self.commands.messages[seen:]:
                if all(map(math.isfinite, (command.linear.x, command.angular.z))):  # as the simulator does
                    turtle.command(self.now, command.linear.x, command.angular.z)
            for _ in range(steps):
                self.now += STEP
                before = turtle.theta
                self.bumps += len(self._world.step(self.now))
                self.turned += abs(math.remainder(turtle.theta - before, 2 * math.pi))
            if until():
                return True
        return False

    def _steps(self) -> int:
        """Steps until the next pose."""
        allowed = min(FAR / max(self.turtle.linear, 1e-9), TURN / max(abs(self.turtle.angular), 1e-9)) / STEP
        return int(max(FEWEST, min(MOST, allowed)))
