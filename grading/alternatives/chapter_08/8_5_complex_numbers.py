# Exercise 8.5: steering
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
