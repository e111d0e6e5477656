"""A robot's way, retraced from the commands that were heard."""

import pytest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

from helpers.runner.retracing import AHEAD, Way


class Ears:
    """In place of a node: what is said on a topic is heard at once."""

    def __init__(self):
        self.heard = {}

    def create_subscription(self, kind, topic, callback, depth, event_callbacks=None):
        self.heard[topic] = callback

    def odometry(self, seconds, x=0.0):
        message = Odometry()
        message.header.stamp.sec, message.header.stamp.nanosec = int(seconds), round(seconds % 1 * 1e9)
        message.pose.pose.position.x = x
        self.heard['odom'](message)

    def command(self, linear):
        message = Twist()
        message.linear.x = linear
        self.heard['cmd_vel'](message)


@pytest.fixture
def ears():
    return Ears()


def test_commands_lead_somewhere(ears):
    way = Way(ears, 1e9)
    for tenth in range(50):
        ears.odometry(100.0 + tenth / 10)
        ears.command(0.3 if tenth < 40 else 0.0)
    assert way.retraced() == pytest.approx(1.2, abs=0.1)


def test_a_robot_that_nobody_commands_stays(ears):
    way = Way(ears, 1e9)
    for tenth in range(50):
        ears.odometry(tenth / 10, x=tenth / 10)
    assert (way.odometer, way.retraced()) == (4.9, pytest.approx(0.0, abs=0.01))


def test_a_command_is_not_kept_for_ever(ears):
    """As in the world: without another command the robot stops after half a second."""
    way = Way(ears, 1e9)
    ears.odometry(0.0)
    ears.command(0.4)
    ears.odometry(20.0)
    assert way.retraced() < 0.4


def test_a_clock_that_runs_ahead_makes_no_way(ears):
    way = Way(ears, 1.0)
    for second in range(500):
        ears.odometry(float(second))
        ears.command(1.0)
    assert way.retraced() < AHEAD + 0.5


def test_what_is_no_number_is_no_command(ears):
    way = Way(ears, 1e9)
    ears.odometry(0.0)
    ears.command(float('nan'))
    ears.odometry(1.0)
    assert way.retraced() == pytest.approx(0.0, abs=0.01)
