# expect: came out at once
# rejected by: test_one_out_for_each_in
# told by: test_distance_in_metres
# Exercise 3.2: from centimetres to metres
from sensor_msgs.msg import Range


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.last = None
        self.create_timer(0.1, self.on_timer)
        self.subscription = self.create_subscription(Range, 'sonar_cm', self.on_range, 10)

    def on_range(self, msg):
        msg.range /= 100
        msg.min_range /= 100
        msg.max_range /= 100
        msg.variance /= 100**2
        self.last = msg

    def on_timer(self):
        if self.last:
            self.publisher.publish(self.last)
