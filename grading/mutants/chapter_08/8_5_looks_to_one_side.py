# expect: to the left of its goal
# rejected by: test_turns_on_the_spot
# Exercise 8.5: steering
def steer(x, y, yaw, goal_x, goal_y, max_linear, max_angular):
    """Return distance in m, linear in m/s and angular in rad/s towards a goal.

    Places are in m, yaw in rad, all in one frame.
    """
    dx, dy = goal_x - x, goal_y - y
    distance = math.hypot(dx, dy)
    angle = math.remainder(math.atan2(dy, dx) - yaw, math.tau) if distance else 0.0
    linear = min(max_linear, distance) if angle <= 0.5 else 0.0
    return distance, linear, max(-max_angular, min(max_angular, 2 * angle))
