# expect: gives None, expected []
# rejected by: test_all_pairs
# told by: test_equal_endpoints_fit
# Exercise 3.5: why is there no data?
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool


def why_no_data(offered, requested):
    strength = {'BEST_EFFORT': 0, 'RELIABLE': 1, 'VOLATILE': 0, 'TRANSIENT_LOCAL': 1}
    reasons = [key for key in ('topic', 'type') if offered[key] != requested[key]]
    reasons += [key for key in ('reliability', 'durability') if strength[offered[key]] < strength[requested[key]]]
    if (offered['deadline'] or float('inf')) > (requested['deadline'] or float('inf')):
        reasons.append('deadline')
    return reasons or None


class SafetyStop(Node):
    def __init__(self):
        super().__init__('safety_stop')
        command = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.publisher = self.create_publisher(Bool, 'stop', command)
        self.subscription = self.create_subscription(LaserScan, 'scan', self.on_scan, sensor)

    def on_scan(self, scan):
        self.publisher.publish(Bool(data=any(distance < 0.5 for distance in scan.ranges)))
