# expect: No test of yours notices a function that does not slow down
# rejected by: test_drives
# Exercise 8.6: tests for the steering
TEST_STEERING = '''
import math

import pytest
from delivery_robot.steering import steer


def test_straight_ahead():
    assert steer(0.0, 0.0, 0.0, 3.0, 0.0, 0.5, 1.0) == pytest.approx((3.0, 0.5, 0.0))


@pytest.mark.parametrize('angle, angular', [
    (0.0, 0.0), (0.1, 0.2), (-0.1, -0.2), (0.4, 0.8), (-0.4, -0.8), (0.9, 1.5), (-0.9, -1.5), (3.0, 1.5), (-3.0, -1.5)])
@pytest.mark.parametrize('yaw', [0.0, 1.5, 3.1, -3.1, 7.0])
def test_turns(yaw, angle, angular):
    goal = 1.0 + 2.0 * math.cos(yaw + angle), -2.0 + 2.0 * math.sin(yaw + angle)
    distance, linear, turn = steer(1.0, -2.0, yaw, *goal, 0.5, 1.5)
    assert (distance, turn) == pytest.approx((2.0, angular), abs=1e-6)
    assert linear == pytest.approx(0.5 if abs(angle) < 0.5 else 0.0)


@pytest.mark.parametrize('distance, linear', [(5.0, 0.7), (0.8, 0.7)])
def test_slows_down(distance, linear):
    assert steer(0.0, 1.0, 0.0, distance, 1.0, 0.7, 1.0) == pytest.approx((distance, linear, 0.0))


def test_at_the_goal():
    assert steer(1.0, 2.0, 0.3, 1.0, 2.0, 0.5, 1.0) == pytest.approx((0.0, 0.0, 0.0))
'''
