# expect: divide by 100
# rejected by: test_all_distances
# told by: test_distance_in_metres
# Exercise 3.2: from centimetres to metres
from sensor_msgs.msg import Range


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.subscription = self.create_subscription(Range, 'sonar_cm', self.on_range, 10)

    def on_range(self, msg):
        msg.range *= 100
        msg.min_range *= 100
        msg.max_range *= 100
        msg.variance *= 100**2
        self.publisher.publish(msg)
