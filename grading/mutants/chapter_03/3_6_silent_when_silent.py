# expect: dead sensor must not look like a quiet one
# rejected by: test_silent_sensor
# told by: test_silence
# Exercise 3.6: a rate and gap monitor
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64


class RateMonitor(Node):
    def __init__(self, max_gap=0.5):
        super().__init__('rate_monitor')
        self.max_gap, self.count, self.newest = max_gap, 0, None
        self.rate = self.create_publisher(Float64, 'scan_rate', 10)
        self.gap = self.create_publisher(Float64, 'scan_gap', 10)
        self.create_subscription(LaserScan, 'scan', self.on_scan, sensor)
        self.create_timer(1.0, self.on_second)

    def on_scan(self, scan):
        self.count += 1
        stamp = Time.from_msg(scan.header.stamp)
        gap = (stamp - (self.newest or stamp)).nanoseconds / 1e9
        if gap > self.max_gap:
            self.gap.publish(Float64(data=gap))
        self.newest = stamp if gap >= 0 else self.newest

    def on_second(self):
        if self.count:
            self.rate.publish(Float64(data=float(self.count)))
        self.count = 0
