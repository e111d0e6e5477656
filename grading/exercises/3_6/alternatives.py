from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('helper_object', source='''
from rclpy.duration import Duration
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64


class GapFinder:
    """Pure logic, without ROS communication: gives the gap before a stamp, or None."""

    def __init__(self, max_gap):
        self.max_gap = Duration(seconds=max_gap)
        self.newest = None

    def __call__(self, stamp):
        before, self.newest = self.newest, stamp if self.newest is None else max(self.newest, stamp)
        if before is not None and stamp - before > self.max_gap:
            return (stamp - before).nanoseconds * 1e-9
        return None


class RateMonitor(Node):
    def __init__(self, max_gap=0.5):
        super().__init__('rate_monitor')
        self.find_gap = GapFinder(max_gap)
        self.scans = 0
        self.publish = {name: self.create_publisher(Float64, f'scan_{name}', 10).publish for name in ('rate', 'gap')}
        self.create_subscription(LaserScan, 'scan', self.on_scan, qos_profile_sensor_data)
        self.create_timer(1.0, self.on_timer)

    def on_scan(self, scan):
        self.scans += 1
        gap = self.find_gap(Time.from_msg(scan.header.stamp))
        if gap:
            self.publish['gap'](Float64(data=gap))

    def on_timer(self):
        self.publish['rate'](Float64(data=float(self.scans)))
        self.scans = 0
'''),
    Alternative('nanoseconds', source='''
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
'''),
    Alternative('a_subscription_for_each_job', source='''
from rclpy.duration import Duration
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64


class Rates:
    def __init__(self, node):
        self.count = 0
        self.publisher = node.create_publisher(Float64, 'scan_rate', 10)
        node.create_subscription(LaserScan, 'scan', self.on_scan, qos_profile_sensor_data)
        node.create_timer(1.0, self.on_timer)

    def on_scan(self, _):
        self.count += 1

    def on_timer(self):
        self.publisher.publish(Float64(data=float(self.count)))
        self.count = 0


class Gaps:
    def __init__(self, node, limit):
        self.limit, self.newest = Duration(seconds=limit), None
        self.publisher = node.create_publisher(Float64, 'scan_gap', 10)
        node.create_subscription(LaserScan, 'scan', self.on_scan, qos_profile_sensor_data)

    def on_scan(self, scan):
        now = Time.from_msg(scan.header.stamp)
        if self.newest and now - self.newest > self.limit:
            self.publisher.publish(Float64(data=(now - self.newest).nanoseconds / 1e9))
        self.newest = max(now, self.newest or now)


class RateMonitor(Node):
    def __init__(self, max_gap=0.5):
        super().__init__('rate_monitor')
        self.parts = Rates(self), Gaps(self, max_gap)
'''),
]
