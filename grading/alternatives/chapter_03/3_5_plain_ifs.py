# Exercise 3.5: why is there no data?
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool


def why_no_data(offered, requested):
    result = []
    if offered['topic'] != requested['topic']:
        result += ['topic']
    if offered['type'] != requested['type']:
        result += ['type']
    if requested['reliability'] == 'RELIABLE' and offered['reliability'] == 'BEST_EFFORT':
        result += ['reliability']
    if requested['durability'] == 'TRANSIENT_LOCAL' and offered['durability'] == 'VOLATILE':
        result += ['durability']
    if requested['deadline'] != 0 and (offered['deadline'] == 0 or offered['deadline'] > requested['deadline']):
        result += ['deadline']
    return result


class SafetyStop(Node):
    def __init__(self):
        Node.__init__(self, 'safety_stop')
        keep = QoSProfile(depth=1)
        keep.durability = DurabilityPolicy.TRANSIENT_LOCAL
        self.stop = self.create_publisher(Bool, 'stop', qos_profile=keep)
        self.create_subscription(LaserScan, 'scan', callback=self.on_scan, qos_profile=qos_profile_sensor_data)

    def on_scan(self, scan):
        near = [distance for distance in scan.ranges if distance < 0.5]
        self.stop.publish(Bool(data=bool(near)))
