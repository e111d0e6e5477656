# expect: It goes round to the right
# rejected by: test_circle
# Exercise 6.2: a moon
class Moon(Node):
    def __init__(self, radius=3.0, period=8.0):
        super().__init__('moon')
        self.radius, self.period = radius, period
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.05, self.tick)

    def tick(self):
        now = self.get_clock().now()
        angle = 2 * math.pi * (now.nanoseconds / 1e9) / self.period
        x, y = self.radius * math.cos(angle), self.radius * -math.sin(angle)
        message = transform('planet', 'moon', x=x, y=y, yaw=angle + math.pi)
        message.header.stamp = now.to_msg()
        self.broadcaster.sendTransform(message)
