"""Hidden tests of exercise 8.6, tests for the steering: other right functions, and other wrong ones of each kind."""

import pytest

from helpers.checks.chapter_08.noticed import Kind, Planted
from helpers.checks.chapter_08.planted import STEERING
from helpers.checks.chapter_08.steerings import variant
from helpers.checks.chapter_08.wrong_steerings import MIRRORED, NAMED, NOTHINGS, ONCE, TURNED, angular, linear

pytestmark = pytest.mark.exercise('8.6')
RIGHT = {
    "the course's": variant(),
    'one whose turn is limited first': variant(
        angular='    half = max_angular / 2\n    angular = 2 * max(-half, min(half, angle))\n'
    ),
    'one that asks for the distance with **': variant(
        way='    dx, dy = goal_x - x, goal_y - y\n    distance = (dx ** 2 + dy ** 2) ** 0.5\n'
    ),
    'one that computes the angle from the goal to the robot': variant(
        way='    dx, dy = goal_x - x, goal_y - y\n    distance = (dx * dx + dy * dy) ** 0.5\n', angle=MIRRORED
    ),
    'one that returns a named tuple': NAMED,
    'one that turns the world instead of the robot': variant(angle=TURNED),
}
KINDS = (
    Kind(
        'turns',
        'that turn with a wrong angle or a wrong factor',
        {
            'that adds the yaw': variant(angle='    angle = remainder(atan2(dy, dx) + yaw, tau)\n'),
            'that turns with 2.5 times the angle': angular('max(-max_angular, min(max_angular, 2.5 * angle))'),
            'that does not turn when it looks nearly at the goal': angular(
                'max(-max_angular, min(max_angular, 2 * angle)) if abs(angle) > 0.22 else 0.0'
            ),
            'that turns slowly when it looks away from the goal': angular(
                'max(-max_angular, min(max_angular, 2 * angle if abs(angle) < 1.8 else angle / 50))'
            ),
            'that turns to the left, whatever comes': angular('min(max_angular, 2 * abs(angle))'),
        },
    ),
    Kind(
        'short-way',
        'that turn the long way round',
        {
            'that turns the long way round when it looks behind': variant(
                angle='    angle = atan2(dy, dx) - yaw\n    angle -= tau if angle > tau / 2 else 0.0\n'
            ),
            'that turns to the right only': variant(angle='    angle = -((yaw - atan2(dy, dx)) % tau)\n'),
            'that takes a yaw beyond π for π': variant(
                angle='    angle = remainder(atan2(dy, dx) - max(-tau / 2, min(tau / 2, yaw)), tau)\n'
            ),
            'that turns the long way round when its yaw is beyond π': variant(angle=ONCE),
        },
    ),
    Kind(
        'max-angular',
        'that do not keep max_angular',
        {
            'that has no limit at all': angular('2 * angle'),
            'that limits the angle and then doubles it': angular('2 * max(-max_angular, min(max_angular, angle))'),
            'that has no limit to the right': angular('min(max_angular, 2 * angle)'),
        },
    ),
    Kind(
        'speed',
        'that drive with a wrong speed',
        {
            'that slows down too early': linear('min(max_linear, 0.5 * distance) if abs(angle) <= 0.5 else 0.0'),
            'that does not slow down': linear('max_linear if abs(angle) <= 0.5 else 0.0'),
            'that drives a metre a second': linear('min(1.0, distance) if abs(angle) <= 0.5 else 0.0'),
        },
    ),
    Kind(
        'on-the-spot',
        'that do not turn on the spot when they must, or when they must not',
        {
            'that drives when the goal is on its left': linear('min(max_linear, distance) if angle >= -0.5 else 0.0'),
            'that drives slowly while it looks away': linear(
                'min(max_linear, distance) * (1.0 if abs(angle) <= 0.5 else 0.2)'
            ),
            'that drives only if it looks nearly at the goal': linear(
                'min(max_linear, distance) if abs(angle) < 0.05 else 0.0'
            ),
            'that drives only if the goal is less than 0.18 rad aside': linear(
                'min(max_linear, distance) if abs(angle) < 0.18 else 0.0'
            ),
            'that drives unless the goal is behind it': linear(
                'min(max_linear, distance) if abs(angle) < 1.6 else 0.0'
            ),
        },
    ),
    Kind(
        'places',
        'that have a wrong distance, or do not know their place',
        {
            'that knows only x of its place': variant(
                way='    dx, dy = goal_x - x, goal_y\n    distance = hypot(dx, dy)\n'
            ),
            'whose distance is the one along y': variant(
                way='    dx, dy = goal_x - x, goal_y - y\n    distance = abs(dy)\n'
            ),
            'whose distance is squared': variant(
                way='    dx, dy = goal_x - x, goal_y - y\n    distance = dx * dx + dy * dy\n'
            ),
            'that turns at the goal': variant(goal=''),
        },
    ),
)
HIDDEN = Planted(STEERING, 'right-functions', RIGHT, NOTHINGS, KINDS)


@pytest.mark.given
@pytest.mark.rules('right-functions', 'no-ros')
@pytest.mark.weight(3)
def test_right_functions(learner):
    """Your tests pass with every function that does what exercise 8.5 says, however it computes."""
    HIDDEN.accepts(learner)


@pytest.mark.rules('turns')
@pytest.mark.weight(2)
def test_turns(learner):
    """Your tests notice a wrong angle and a wrong factor."""
    HIDDEN.rejects(learner, 'turns')


@pytest.mark.rules('short-way')
def test_short_way(learner):
    """Your tests notice the long way round."""
    HIDDEN.rejects(learner, 'short-way')


@pytest.mark.rules('max-angular')
def test_max_angular(learner):
    """Your tests notice a missing limit of the turn."""
    HIDDEN.rejects(learner, 'max-angular')


@pytest.mark.rules('speed')
@pytest.mark.weight(2)
def test_drives(learner):
    """Your tests notice a wrong speed: near the goal, and at the limit."""
    HIDDEN.rejects(learner, 'speed')


@pytest.mark.rules('on-the-spot')
def test_on_the_spot(learner):
    """Your tests notice a robot that drives while it looks away."""
    HIDDEN.rejects(learner, 'on-the-spot')


@pytest.mark.rules('places')
@pytest.mark.weight(2)
def test_places(learner):
    """Your tests notice a wrong distance, a robot that is taken to be in the origin, and one that turns at its goal."""
    HIDDEN.rejects(learner, 'places')
