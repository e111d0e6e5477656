"""Stands for a governor: has its names and parameters, says what it got, and does nothing until Ctrl+C."""

import json

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Governor(Node):
    def __init__(self):
        super().__init__('governor')
        for name, value in (('max_linear', 0.5), ('slow_linear', 0.2), ('rate', 10.0), ('mode', 'normal')):
            self.declare_parameter(name, value)
        self.output = self.create_publisher(Twist, 'cmd_vel', 10)
        self.input = self.create_subscription(Twist, 'cmd_vel_in', lambda command: None, 10)
        names = ('max_linear', 'slow_linear', 'rate', 'mode')
        print(json.dumps({'node': self.get_fully_qualified_name(), 'publishes': self.output.topic_name,
                          **{name: self.get_parameter(name).value for name in names}}), flush=True)


def main():
    rclpy.init()
    try:
        rclpy.spin(Governor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    rclpy.try_shutdown()
