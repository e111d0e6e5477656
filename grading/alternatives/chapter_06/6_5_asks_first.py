# Exercise 6.5: follow, but not blindly
class Follower(Node):
    """Asks whether there is a transform, and when it was; then transforms the origin of the leader."""

    def __init__(self, leader='turtle1', me='turtle2'):
        super().__init__('follower')
        self.leader, self.me = leader, me
        self.buffer = Buffer(node=self)
        self.listener = TransformListener(self.buffer, self)
        self.motor = self.create_publisher(Twist, f'/{me}/cmd_vel', 10)
        self.timer = self.create_timer(0.1, lambda: self.motor.publish(self.command()))

    def command(self):
        if not self.buffer.can_transform(self.me, self.leader, Time()):
            return Twist()
        newest = self.buffer.get_latest_common_time(self.me, self.leader)
        if self.get_clock().now().nanoseconds - newest.nanoseconds > 500_000_000:
            return Twist()
        origin = PointStamped()
        origin.header.frame_id, origin.header.stamp = self.leader, newest.to_msg()
        there = self.buffer.transform(origin, self.me).point
        return chase(there.x, there.y)
