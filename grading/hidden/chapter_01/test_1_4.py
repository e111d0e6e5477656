"""Hidden tests of exercise 1.4, drive the turtle to a goal."""

import math

import pytest

from helpers.runner import expect
from helpers.runner.turtlesim import TurtleSim

pytestmark = pytest.mark.exercise('1.4')

WITHIN = 0.1  # m
AT_MOST = 20.0  # s
DIZZY = 4 * math.pi  # who has turned so much does not find the goal


def drive(learner, start, goal, namespace='', **options):
    """Let the learner's node drive from `start` (x, y, theta) to `goal`; returns the simulation at the arrival."""
    sim = TurtleSim(learner, *start, namespace=namespace)
    learner.start('GoToGoal', *goal, **options)
    sim.run(AT_MOST, until=lambda: (
        sim.turned > DIZZY or sim.distance(*goal) < WITHIN and sim.turtle.linear < 0.01))
    way = (f'From ({start[0]:.1f}, {start[1]:.1f}), heading {math.degrees(start[2]):.0f}°, '
           f'to ({goal[0]:.1f}, {goal[1]:.1f}): ')
    expect(sim.commands.messages, 'The simulator told its pose, and no command came on cmd_vel.')
    expect(not sim.bumps, f'{way}the turtle ran into a wall.')
    expect(sim.turned < DIZZY or sim.distance(*start[:2]) > 1,
           f'{way}the turtle turns on the spot, round and round. Is the error in radians, and the heading subtracted?')
    expect(sim.turned < DIZZY,
           f'{way}the turtle drives around in circles. Drive slower while the direction is wrong, and near the goal.')
    expect(sim.distance(*goal) >= WITHIN or sim.turtle.linear < 0.01,
           f'{way}the turtle is at the goal and does not stand still.')
    expect(sim.distance(*goal) < WITHIN,
           f'{way}after {AT_MOST:g} s the turtle is {sim.distance(*goal):.2f} m away, at ({sim.turtle.x:.1f}, '
           f'{sim.turtle.y:.1f}), heading {math.degrees(sim.turtle.theta):.0f}°.')
    return sim


def place(random):
    return random.uniform(1.5, 9.5), random.uniform(1.5, 9.5)


def far_places(random):
    """A start and a goal, 4 to 7 m apart and not near a wall."""
    while True:
        start, goal = place(random), place(random)
        if 4 < math.dist(start, goal) < 7:
            return start, goal


@pytest.mark.weight(3)
def test_any_goal(learner):
    """From any place and heading to any goal, and there it stays.

    Decide anew at each pose: the place and the heading are in the message.
    """
    start, goal = far_places(learner.random)
    sim = drive(learner, (*start, learner.random.uniform(-3.1, 3.1)), goal)
    sim.run(2.0)
    expect(sim.distance(*goal) < WITHIN, f'The turtle was at the goal and left it: after 2 s more it is '
                                         f'{sim.distance(*goal):.2f} m away. Tell it zero, and go on telling it.')


@pytest.mark.weight(2)
def test_the_short_way_round(learner):
    """The turtle turns the short way, also where the angle jumps from π to −π.

    math.remainder(error, 2 * math.pi) brings the error into −π … π.
    """
    # Heading just below pi, goal just beyond it: the difference of the two angles is nearly a whole turn.
    tilt = learner.random.uniform(0.3, 0.5)
    heading = math.pi - tilt
    goal = (8.0 - 4.0 * math.cos(tilt), 5.5 - 4.0 * math.sin(tilt))
    sim = drive(learner, (8.0, 5.5, heading), goal)
    expect(sim.turned < 2 * tilt + 1.5,
           f'The goal was {math.degrees(2 * tilt):.0f}° to the left, and the turtle turned by '
           f'{math.degrees(sim.turned):.0f}° in all: the long way round. The angle jumps at π.')


@pytest.mark.weight(2)
def test_a_goal_behind(learner):
    """A goal behind the turtle, near a wall, is reached without touching a wall.

    Turn first; drive when the direction is nearly right.
    """
    y = learner.random.uniform(4.0, 7.0)
    drive(learner, (10.2, y, learner.random.uniform(-0.2, 0.2)), (6.5, y + learner.random.uniform(-0.5, 0.5)))


def test_names(learner):
    """The topics are relative: in the namespace /sim2 they are /sim2/turtle1/pose and /sim2/turtle1/cmd_vel.

    No slash at the beginning of a topic's name.
    """
    sim = TurtleSim(learner, 5.0, 5.0, 0.0, namespace='/sim2')
    node = learner.start('GoToGoal', 8.0, 5.0, remap={'__ns': '/sim2'})
    expect(node.name == '/sim2/go_to_goal', f'The node is called {node.name}, expected /sim2/go_to_goal.')
    sim.run(0.5)
    expect(sim.commands.messages, 'In the namespace /sim2 the node does not drive its turtle: its topics are absolute.')


def test_at_the_goal_already(learner):
    """Who starts at the goal stands still at once.

    math.atan2(0, 0) is 0, and that is no direction to drive in.
    """
    x, y = place(learner.random)
    sim = TurtleSim(learner, x, y, learner.random.uniform(1.0, 3.0))
    learner.start('GoToGoal', x, y)
    sim.run(1.0)
    expect(sim.distance(x, y) < WITHIN and sim.turtle.linear < 0.01,
           f'The turtle stood at its goal, and after 1 s it is {sim.distance(x, y):.2f} m away.')
