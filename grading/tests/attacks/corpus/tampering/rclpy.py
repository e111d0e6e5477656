# attack: replaces publishers, clocks and executors of rclpy
# row: 4
# aims at: 90.3
# stopped by: what counts is what arrives on the wire
# expect verdict: failed or learner_crashed or timeout
# expect message: messages came or your code raised or did not return
import rclpy.executors
import rclpy.publisher

rclpy.publisher.Publisher.publish = lambda self, message: None


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.publisher.publish(String(data='n0'))
