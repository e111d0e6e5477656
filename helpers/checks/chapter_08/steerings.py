"""Steering for exercises 8.5 and 8.6: what is right, and texts of right and wrong functions."""

import math

HEAD = '''\
from math import atan2, hypot, remainder, tau


def steer(x, y, yaw, goal_x, goal_y, max_linear, max_angular):
'''
PARTS = {
    'way': '    dx, dy = goal_x - x, goal_y - y\n    distance = hypot(dx, dy)\n',
    'angle': '    angle = remainder(atan2(dy, dx) - yaw, tau)\n',
    'goal': '    if distance == 0:\n        return 0.0, 0.0, 0.0\n',
    'angular': '    angular = max(-max_angular, min(max_angular, 2 * angle))\n',
    'linear': '    linear = min(max_linear, distance) if abs(angle) <= 0.5 else 0.0\n',
    'result': '    return distance, linear, angular\n',
}


def variant(**parts: str) -> str:
    """The right function, with these parts in place of its own; an empty text leaves a part out."""
    return HEAD + ''.join({**PARTS, **parts}.values())


def right(x: float, y: float, yaw: float, goal_x: float, goal_y: float, max_linear: float,
          max_angular: float) -> tuple[float, float, float]:
    """What `steer` must return: distance in m, linear in m/s, angular in rad/s."""
    distance = math.dist((x, y), (goal_x, goal_y))
    angle = math.remainder(math.atan2(goal_y - y, goal_x - x) - yaw, math.tau) if distance else 0.0
    linear = min(max_linear, distance) if abs(angle) <= 0.5 else 0.0
    return distance, linear, math.copysign(min(max_angular, 2 * abs(angle)), angle)


def words(arguments) -> str:
    """A call of `steer`, for messages."""
    return f"steer({', '.join(f'{value:g}' for value in arguments)})"
