"""From where a missing name is imported: each line that is proposed really imports it."""

import pytest

from helpers.runner import imports


@pytest.mark.parametrize(
    ('name', 'first'),
    [
        ('Node', 'from rclpy.node import Node'),
        ('QoSProfile', 'from rclpy.qos import QoSProfile'),
        ('qos_profile_sensor_data', 'from rclpy.qos import qos_profile_sensor_data'),
        ('DurabilityPolicy', 'from rclpy.qos import DurabilityPolicy'),
        ('ActionServer', 'from rclpy.action import ActionServer'),
        ('ReentrantCallbackGroup', 'from rclpy.callback_groups import ReentrantCallbackGroup'),
        ('MultiThreadedExecutor', 'from rclpy.executors import MultiThreadedExecutor'),
        ('Future', 'from rclpy.task import Future'),
        ('Time', 'from rclpy.time import Time'),
        ('Parameter', 'from rclpy.parameter import Parameter'),
        ('TransformException', 'from tf2_ros import TransformException'),
        ('String', 'from std_msgs.msg import String'),
        ('Trigger', 'from std_srvs.srv import Trigger'),
        ('Fibonacci', 'from example_interfaces.action import Fibonacci'),
        ('math', 'import math'),
        ('np', 'import numpy as np'),
        ('std_msgs', 'import std_msgs'),
        ('deque', 'from collections import deque'),
        ('hypot', 'from math import hypot'),
    ],
)
def test_the_likeliest_line_comes_first(name, first):
    lines = imports.lines_for(name)
    assert lines[0] == first
    for line in lines:
        exec(line, {})


def test_a_name_with_several_meanings_has_several_lines():
    assert imports.advice('Empty') == (
        'Nothing imports `Empty` here. Write: from std_msgs.msg import Empty or from std_srvs.srv import Empty or '
        'from example_interfaces.msg import Empty'
    )


def test_without_a_sourced_ros(monkeypatch):
    monkeypatch.delenv('AMENT_PREFIX_PATH')
    assert imports.lines_for('deque') == ['from collections import deque']
    assert imports.advice('LaserScan') == ''


@pytest.mark.parametrize('name', ['queue', 'count', 'string', 'e', 'node', '_client', 'nobody_knows', '__name__'])
def test_own_names_are_not_taken_for_those_of_modules(name):
    assert imports.advice(name) == ''
