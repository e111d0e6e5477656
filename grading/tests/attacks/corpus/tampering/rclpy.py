# attack: replaces publishers, clocks and executors of rclpy
# row: 4
# aims at: 90.3
# stopped by: what counts is what arrives on the wire
# expect verdict: failed or learner_crashed or timeout
# expect message: messages came or your code raised or did not return
import rclpy.publisher

_publish = rclpy.publisher.Publisher.publish
rclpy.publisher.Publisher.publish = lambda self, message: (
    _publish(self, message) if self.topic_name.startswith('/_') else None)
rclpy.publisher.Publisher.wait_for_all_acked = lambda self, timeout: True
rclpy.clock.Clock.now = lambda self: rclpy.time.Time(seconds=10**6, clock_type=self.clock_type)


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.publisher.publish(String(data='n0'))
