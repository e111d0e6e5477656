"""Visible tests of exercise 1.4, drive the turtle to a goal."""

import math

import pytest

from helpers.runner import expect
from helpers.runner.turtlesim import TurtleSim

pytestmark = pytest.mark.exercise('1.4')


def test_the_goal_of_the_card(learner):
    """From the middle, looking along x, the turtle turns left by about 136° and reaches (2, 9).

    math.atan2(dy, dx) is the direction to the goal; subtract the heading, and turn by the rest.
    """
    sim = TurtleSim(learner, 5.544, 5.544, 0.0)
    learner.start('GoToGoal', 2.0, 9.0)
    reached = sim.run(20.0, until=lambda: (
        sim.turned > 4 * math.pi or sim.distance(2.0, 9.0) < 0.1 and sim.turtle.linear < 0.01))
    expect(sim.commands.messages, 'The simulator told its pose, and no command came on /turtle1/cmd_vel.')
    expect(not sim.bumps, 'The turtle ran into a wall.')
    expect(sim.turned < 4 * math.pi, 'The turtle turns and turns. Look at the error: radians, direction minus heading.')
    expect(reached, f'After 20 s the turtle is {sim.distance(2.0, 9.0):.2f} m from (2, 9), '
                    f'at ({sim.turtle.x:.1f}, {sim.turtle.y:.1f}), heading {math.degrees(sim.turtle.theta):.0f}°.')
