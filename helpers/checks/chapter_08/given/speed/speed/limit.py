"""How fast a robot may drive. There is no ROS in here."""

from math import isnan


def limit(speed, max_speed, distance):
    """Return the speed that may be driven, in m/s: `speed`, or less of it.

    It is never faster than `max_speed`, in both directions. Backwards (a negative speed), nothing else matters.

    Forwards, `distance` is the way to the next obstacle in m; inf if there is none. From 1.0 m on, `max_speed` is
    allowed. At 0.2 m and below, the robot stands. In between, the allowed speed rises in proportion, from 0 to
    `max_speed`. A distance of nan means that the sensor has failed: the robot does not drive forwards.

    :raises ValueError: `max_speed` is negative or nan.
    """
    if not max_speed >= 0:
        raise ValueError('max_speed must not be negative')
    if speed <= 0:
        return max(speed, -max_speed)
    if isnan(distance) or distance <= 0.2:
        return 0.0
    share = min(1.0, (distance - 0.2) / (1.0 - 0.2))
    return min(speed, max_speed * share)
