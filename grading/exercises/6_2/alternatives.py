from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('half_angles', source='''
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
'''),
    Alternative('matrices', source='''
from tf_transformations import euler_matrix, quaternion_from_matrix, translation_matrix


class Moon(Node):
    """Turn, go out, look back: a product of matrices."""

    def __init__(self, radius=3.0, period=8.0):
        super().__init__('moon')
        self.speed = 2 * math.pi / period
        self.out = translation_matrix((radius, 0.0, 0.0)) @ euler_matrix(0.0, 0.0, math.pi)
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.05, self.tick)

    def tick(self):
        now = self.get_clock().now()
        there = euler_matrix(0.0, 0.0, self.speed * now.nanoseconds * 1e-9) @ self.out
        x, y, z, w = map(float, quaternion_from_matrix(there))
        message = transform('planet', 'moon', *there[:3, 3])
        message.transform.rotation = Quaternion(x=x, y=y, z=z, w=w)
        message.header.stamp = now.to_msg()
        self.broadcaster.sendTransform([message])
'''),
    Alternative('complex_and_async', source='''
import cmath


class Moon(Node):
    """A complex number that turns; a later look at the clock, which the transform does not use."""

    def __init__(self, radius=3.0, period=8.0):
        super().__init__('moon')
        self.out, self.speed = complex(radius), 2j * math.pi / period
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.05, self.tick, clock=self.get_clock())
        self.said = self.get_clock().now()

    async def tick(self):
        stamp = self.get_clock().now().to_msg()
        turned = cmath.exp(self.speed * (stamp.sec + stamp.nanosec / 1e9))
        place = self.out * turned
        message = transform('planet', 'moon', x=place.real, y=place.imag, yaw=cmath.phase(-turned))
        message.header.stamp = stamp
        self.broadcaster.sendTransform(message)
        self.said = self.get_clock().now()
'''),
]
