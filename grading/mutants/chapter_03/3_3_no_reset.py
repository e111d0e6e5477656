# expect: changes nothing
# rejected by: test_every_reset
# told by: test_reset
# Exercise 3.3: heartbeat
from std_msgs.msg import Bool, Empty, Int32


class Heartbeat(Node):
    def __init__(self):
        super().__init__('heartbeat')
        self.lit = False
        self.seconds = 0
        self.led = self.create_publisher(Bool, 'led', 10)
        self.uptime = self.create_publisher(Int32, 'uptime', 10)
        self.create_timer(0.25, self.on_blink)
        self.create_timer(1.0, self.on_second)

    def on_blink(self):
        self.lit = not self.lit
        self.led.publish(Bool(data=self.lit))

    def on_second(self):
        self.seconds += 1
        self.uptime.publish(Int32(data=self.seconds))

    def on_reset(self, msg):
        self.seconds = 0
