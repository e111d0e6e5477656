from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('closures', source='''
from itertools import count, cycle

import std_msgs.msg as std


class Heartbeat(rclpy.node.Node):
    def __init__(self, **options):
        super().__init__('heartbeat', **options)
        self.states = cycle([True, False])
        self.restart()
        led = self.create_publisher(std.Bool, 'led', 10)
        uptime = self.create_publisher(std.Int32, 'uptime', 10)
        self.create_timer(0.25, lambda: led.publish(std.Bool(data=next(self.states))))
        self.create_timer(1, lambda: uptime.publish(std.Int32(data=next(self.seconds))))
        self.create_subscription(std.Empty, 'reset', self.restart, 10)

    def restart(self, message=None):
        self.seconds = count(1)
'''),
    Alternative('one_timer', source='''
from std_msgs.msg import Bool, Empty, Int32


class Heartbeat(Node):
    """One timer of 0.25 s for both jobs: every fourth call is a second."""

    def __init__(self):
        super().__init__('heartbeat')
        self.calls = 0
        self.zero = 0
        self.led = self.create_publisher(Bool, 'led', 10)
        self.uptime = self.create_publisher(Int32, 'uptime', 10)
        self.subscription = self.create_subscription(Empty, 'reset', self.reset, 10)
        self.timer = self.create_timer(0.25, self.tick)

    def reset(self, _):
        self.zero = self.calls // 4

    def tick(self):
        self.calls += 1
        self.led.publish(Bool(data=self.calls % 2 == 1))
        if self.calls % 4 == 0:
            self.uptime.publish(Int32(data=self.calls // 4 - self.zero))
'''),
]
