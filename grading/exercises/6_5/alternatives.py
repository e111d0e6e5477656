from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('asks_first', source='''
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
'''),
    Alternative('from_the_back', source='''
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
'''),
]
