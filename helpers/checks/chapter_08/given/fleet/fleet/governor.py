"""Stands for a governor: reports its names and parameters as one line of JSON, and ends.

The line is printed, and added to the file that the environment variable FLEET_REPORT names.
"""

import json
import os

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Governor(Node):
    def __init__(self):
        super().__init__('governor')
        for name, value in (('max_linear', 0.5), ('slow_linear', 0.2), ('rate', 10.0), ('mode', 'normal')):
            self.declare_parameter(name, value)
        self.output = self.create_publisher(Twist, 'cmd_vel', 10)
        self.input = self.create_subscription(Twist, 'cmd_vel_in', lambda command: None, 10)

    def report(self):
        names = ('max_linear', 'slow_linear', 'rate', 'mode')
        return {'node': self.get_fully_qualified_name(), 'publishes': self.output.topic_name,
                'listens': self.input.topic_name, **{name: self.get_parameter(name).value for name in names}}


def main():
    rclpy.init()
    line = json.dumps(Governor().report())
    print(line, flush=True)
    if 'FLEET_REPORT' in os.environ:
        with open(os.environ['FLEET_REPORT'], 'a') as file:
            file.write(line + '\n')
    rclpy.try_shutdown()
