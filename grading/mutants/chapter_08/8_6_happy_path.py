# expect: No test of yours notices a function that forgets where the robot looks
# rejected by: test_turns
# Exercise 8.6: tests for the steering
TEST_STEERING = '''
import math

import pytest
from delivery_robot.steering import steer


def test_straight_ahead():
    assert steer(0.0, 0.0, 0.0, 3.0, 0.0, 0.5, 1.0) == pytest.approx((3.0, 0.5, 0.0))
'''
