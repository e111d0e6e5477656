# Exercise 3.3: heartbeat
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
