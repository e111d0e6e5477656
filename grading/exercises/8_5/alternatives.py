from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('complex_numbers', source='''
import cmath


def steer(x, y, yaw, goal_x, goal_y, max_linear, max_angular):
    way = complex(goal_x - x, goal_y - y)
    if way == 0:
        return 0.0, 0.0, 0.0
    angle = cmath.phase(way * cmath.exp(-1j * yaw))
    angular = math.copysign(min(2 * abs(angle), max_angular), angle)
    if -0.5 <= angle <= 0.5:
        return abs(way), min(abs(way), max_linear), angular
    return abs(way), 0.0, angular
'''),
    Alternative('numpy', source='''
import numpy as np


def steer(x, y, yaw, goal_x, goal_y, max_linear, max_angular):
    to_goal = np.array([goal_x, goal_y]) - np.array([x, y])
    distance = float(np.linalg.norm(to_goal))
    if distance == 0.0:
        return [0.0, 0.0, 0.0]
    angle = float(np.arctan2(*to_goal[::-1])) - yaw
    angle = float(np.arctan2(np.sin(angle), np.cos(angle)))
    linear = 0.0 if abs(angle) > 0.5 else min(distance, max_linear)
    return [distance, linear, float(np.clip(2 * angle, -max_angular, max_angular))]
'''),
]
