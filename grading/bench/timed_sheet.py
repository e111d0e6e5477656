"""The sheet that graders are timed on: two pure functions and a talker, in right answers."""

MEAN = """\
def mean(values):
    return sum(values) / len(values)
"""
CLAMP = """\
def clamp(value, low, high):
    return max(low, min(high, value))
"""
TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.1, self.speak)

    def speak(self):
        self.publisher.publish(String(data='hello'))
"""
ANSWERS = (MEAN, CLAMP, TALKER)
NAMES = ('mean', 'clamp', 'Talker')
