# expect: It gets the last message of each publisher
# rejected by: test_tree
# Exercise 6.1: a sensor mast
from rclpy.qos import DurabilityPolicy, QoSProfile
from tf2_msgs.msg import TFMessage


class SensorMast(Node):
    def __init__(self, height=1.0, tilt=20.0):
        super().__init__('sensor_mast')
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.publisher = self.create_publisher(TFMessage, '/tf_static', latched)
        for message in (
            transform('base_link', 'mast', x=-0.1, z=0.3),
            transform('mast', 'lidar', z=height, roll=math.pi),
            transform('mast', 'camera', x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
            transform('camera', 'camera_optical', roll=-math.pi / 2, yaw=-math.pi / 2),
        ):
            self.publisher.publish(TFMessage(transforms=[message]))
