# expect: the header is lost
# rejected by: test_header_is_kept
# Exercise 3.2: from centimetres to metres
from sensor_msgs.msg import Range


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.subscription = self.create_subscription(Range, 'sonar_cm', self.on_range, 10)

    def on_range(self, msg):
        out = Range(range=msg.range / 100, min_range=msg.min_range / 100, max_range=msg.max_range / 100,
                    variance=msg.variance / 100**2, radiation_type=msg.radiation_type,
                    field_of_view=msg.field_of_view)
        self.publisher.publish(out)
