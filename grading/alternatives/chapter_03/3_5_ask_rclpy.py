# Exercise 3.5: why is there no data?
import math

from rclpy.qos import QoSCompatibility, QoSProfile, qos_check_compatible
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool


def policy_fits(key, offered, requested):
    enum = {'reliability': ReliabilityPolicy, 'durability': DurabilityPolicy}[key]
    profiles = [QoSProfile(depth=1, **{key: enum[side[key]]}) for side in (offered, requested)]
    return qos_check_compatible(*profiles)[0] != QoSCompatibility.ERROR


def why_no_data(offered, requested):
    period = lambda side: side['deadline'] if side['deadline'] > 0 else math.inf
    checks = {
        'topic': offered['topic'] == requested['topic'],
        'type': offered['type'] == requested['type'],
        'reliability': policy_fits('reliability', offered, requested),
        'durability': policy_fits('durability', offered, requested),
        'deadline': period(offered) <= period(requested),
    }
    return [key for key, fits in checks.items() if not fits]


class SafetyStop(Node):
    def __init__(self):
        super().__init__('safety_stop')
        latched = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE,
                             durability=DurabilityPolicy.TRANSIENT_LOCAL)
        lidar = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
        self.publisher = self.create_publisher(Bool, 'stop', latched)
        self.subscription = self.create_subscription(LaserScan, 'scan', self.on_scan, lidar)

    def on_scan(self, scan):
        self.publisher.publish(Bool(data=min(scan.ranges, default=math.inf) < 0.5))
