"""Functions for exercise 8.6: right and wrong ones of each kind, that its visible tests use."""

from helpers.checks.chapter_08.noticed import Kind, Planted
from helpers.checks.chapter_08.planted import NOTHING, STEERING
from helpers.checks.chapter_08.steerings import variant

NOTHINGS = {'that returns nothing': variant(result=NOTHING)}
TURNED = (
    '    from math import cos, sin\n    angle = atan2(dy * cos(yaw) - dx * sin(yaw), dx * cos(yaw) + dy * sin(yaw))\n'
)
MIRRORED = '    angle = -remainder(yaw - atan2(dy, dx), tau)\n'
# Right as long as the yaw is from -π to π.
ONCE = """\
    angle = atan2(dy, dx) - yaw
    angle += tau if angle < -tau / 2 else -tau if angle > tau / 2 else 0.0
"""
NAMED = variant(
    goal='    if distance == 0:\n        angle = 0\n',
    result="""\
    from collections import namedtuple

    values = [round(one) if abs(one - round(one)) < 1e-9 else one for one in (distance, linear, angular)]
    return namedtuple('Steering', 'distance linear angular')(*values)
""",
)
RIGHT = {
    "the course's": variant(),
    'one that computes its angle and its distance in another way': variant(
        way='    dx, dy = goal_x - x, goal_y - y\n    distance = (dx ** 2 + dy ** 2) ** 0.5\n',
        angle='    from math import cos, sin\n    angle = atan2(dy, dx) - yaw\n'
        '    angle = atan2(sin(angle), cos(angle))\n',
    ),
    'one that turns the world instead of the robot': variant(angle=TURNED),
    'one that returns a named tuple, and an int for each whole number': NAMED,
    'one that returns -0.0 straight ahead': variant(angle=MIRRORED),
}


def angular(text: str) -> str:
    """A function with another turn."""
    return variant(angular=f'    angular = {text}\n')


def linear(text: str) -> str:
    """A function with another speed."""
    return variant(linear=f'    linear = {text}\n')


KINDS = (
    Kind(
        'turns',
        'that turn with a wrong angle or a wrong factor',
        {
            'that mixes up left and right': variant(result='    return distance, linear, -angular\n'),
            'that forgets where the robot looks': variant(angle='    angle = remainder(atan2(dy, dx), tau)\n'),
            'that turns with 1 times the angle': angular('max(-max_angular, min(max_angular, angle))'),
            'that always turns as fast as it may': angular(
                'max_angular if angle > 0 else -max_angular if angle < 0 else 0.0'
            ),
            'that does not turn when the goal is less than 0.25 rad aside': angular(
                'max(-max_angular, min(max_angular, 2 * angle)) if abs(angle) >= 0.25 else 0.0'
            ),
            'that turns with 3 times the angle': angular('max(-max_angular, min(max_angular, 3 * angle))'),
            'that turns slowly when the goal is behind it': angular(
                'max(-max_angular, min(max_angular, 2 * angle if abs(angle) < 1.6 else angle / 40))'
            ),
        },
    ),
    Kind(
        'short-way',
        'that turn the long way round',
        {
            'that turns the long way round': variant(angle='    angle = atan2(dy, dx) - yaw\n'),
            'that turns to the left only': variant(angle='    angle = (atan2(dy, dx) - yaw) % tau\n'),
            'that turns the long way round after a whole turn, when its yaw is more than π': variant(angle=ONCE),
        },
    ),
    Kind(
        'max-angular',
        'that do not keep max_angular',
        {
            'that has no limit to the right': angular('min(max_angular, 2 * angle)'),
            'that has no limit to the left': angular('max(-max_angular, 2 * angle)'),
            'for which max_angular is always 1': angular('max(-1.0, min(1.0, 2 * angle))'),
        },
    ),
    Kind(
        'speed',
        'that drive with a wrong speed',
        {
            'that does not slow down': linear('max_linear if abs(angle) <= 0.5 else 0.0'),
            'that slows down too early': linear('min(max_linear, 0.5 * distance) if abs(angle) <= 0.5 else 0.0'),
            'that has no limit of its speed': linear('distance if abs(angle) <= 0.5 else 0.0'),
            'for which max_linear is always 0.5': linear('min(0.5, distance) if abs(angle) <= 0.5 else 0.0'),
        },
    ),
    Kind(
        'on-the-spot',
        'that do not turn on the spot when they must, or when they must not',
        {
            'that drives while it looks away': linear('min(max_linear, distance)'),
            'that drives when the goal is on its right': linear('min(max_linear, distance) if angle <= 0.5 else 0.0'),
            'that drives only if it looks exactly at the goal': linear(
                'min(max_linear, distance) if abs(angle) < 0.02 else 0.0'
            ),
            'that turns on the spot from 0.15 rad on': linear(
                'min(max_linear, distance) if abs(angle) < 0.15 else 0.0'
            ),
            'that drives if the goal is anywhere in front of it': linear(
                'min(max_linear, distance) if abs(angle) < 1.58 else 0.0'
            ),
        },
    ),
    Kind(
        'places',
        'that have a wrong distance, or do not know their place',
        {
            'that forgets where the robot is': variant(
                way='    dx, dy = goal_x, goal_y\n    distance = hypot(dx, dy)\n'
            ),
            'whose distance is the one along x': variant(
                way='    dx, dy = goal_x - x, goal_y - y\n    distance = abs(dx)\n'
            ),
            'whose distance goes round the corner': variant(
                way='    dx, dy = goal_x - x, goal_y - y\n    distance = abs(dx) + abs(dy)\n'
            ),
            'that turns at the goal': variant(goal=''),
        },
    ),
)
VISIBLE = Planted(STEERING, 'right-functions', RIGHT, NOTHINGS, KINDS, told=True)
