# Exercise 6.2: a moon
from tf2_msgs.msg import TFMessage


class Moon(Node):
    """No broadcaster, and a quaternion by hand."""

    def __init__(self, radius=3.0, period=8.0):
        super().__init__('moon')
        self.publisher = self.create_publisher(TFMessage, '/tf', 100)
        self.timer = self.create_timer(0.05, lambda: self.tell(radius, period))

    def tell(self, radius, period):
        stamp = self.get_clock().now().to_msg()
        turn = (stamp.sec + stamp.nanosec * 1e-9) / period % 1.0
        half = math.pi * turn + math.pi / 2
        message = TransformStamped(child_frame_id='moon')
        message.header.frame_id, message.header.stamp = 'planet', stamp
        message.transform.translation.x = -radius * math.cos(2 * half)
        message.transform.translation.y = -radius * math.sin(2 * half)
        message.transform.rotation = Quaternion(z=math.sin(half), w=math.cos(half))
        self.publisher.publish(TFMessage(transforms=[message]))
