# Exercise 6.5: follow, but not blindly
class Follower(Node):
    """Looks up the other direction, and turns it round by itself."""

    def __init__(self, leader='turtle1', me='turtle2'):
        super().__init__('follower')
        self.frames = leader, me
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.motor = self.create_publisher(Twist, f'{me}/cmd_vel', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        try:
            me_in_leader = self.buffer.lookup_transform(*self.frames, Time())
        except TransformException:
            self.motor.publish(Twist())
            return
        sent = me_in_leader.header.stamp
        now = self.get_clock().now().to_msg()
        if now.sec - sent.sec + (now.nanosec - sent.nanosec) / 1e9 > 0.5:
            self.motor.publish(Twist())
            return
        place, turn = me_in_leader.transform.translation, me_in_leader.transform.rotation
        yaw = euler_from_quaternion([turn.x, turn.y, turn.z, turn.w])[2]
        x = -place.x * math.cos(yaw) - place.y * math.sin(yaw)
        y = place.x * math.sin(yaw) - place.y * math.cos(yaw)
        self.motor.publish(chase(x, y))
