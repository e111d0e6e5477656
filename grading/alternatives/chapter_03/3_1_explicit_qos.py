# Exercise 3.1: a beacon
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy

RATE = 4  # Hz


class Beacon(Node):
    count = 0  # only the first value; += makes an attribute of the object

    def __init__(self):
        super().__init__('beacon')
        profile = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=10, reliability=ReliabilityPolicy.RELIABLE)
        publisher = self.create_publisher(String, 'beacon', profile)
        self.create_timer(1.0 / RATE, lambda: publisher.publish(self.next_text()))

    def next_text(self):
        self.count += 1
        text = String()
        text.data = 'alive ' + str(self.count)
        return text
