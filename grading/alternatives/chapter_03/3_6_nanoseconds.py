# Exercise 3.6: a rate and gap monitor
from rclpy.qos import QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64


class RateMonitor(Node):
    """Counts in whole nanoseconds, and keeps the times of arrival."""

    def __init__(self, max_gap=0.5):
        super().__init__('rate_monitor')
        self.limit = round(max_gap * 1e9)
        self.arrived = []
        self.last = None
        best_effort = QoSProfile(depth=20, reliability=ReliabilityPolicy.BEST_EFFORT)
        self.create_subscription(LaserScan, 'scan', self.heard, best_effort)
        self.rate_out = self.create_publisher(Float64, 'scan_rate', 10)
        self.gap_out = self.create_publisher(Float64, 'scan_gap', 10)
        self.create_timer(1.0, self.report)

    def heard(self, scan):
        self.arrived.append(self.get_clock().now())
        stamp = scan.header.stamp.sec * 10**9 + scan.header.stamp.nanosec
        if self.last is None or stamp > self.last:
            if self.last is not None and stamp - self.last > self.limit:
                self.gap_out.publish(Float64(data=(stamp - self.last) / 1e9))
            self.last = stamp

    def report(self):
        self.rate_out.publish(Float64(data=1.0 * len(self.arrived)))
        self.arrived = []
