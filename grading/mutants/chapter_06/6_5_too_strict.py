# expect: that is good enough
# rejected by: test_follow
# Exercise 6.5: follow, but not blindly
class Follower(Node):
    def __init__(self, leader='turtle1', me='turtle2'):
        super().__init__('follower')
        self.leader, self.me = leader, me
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.motor = self.create_publisher(Twist, f'{me}/cmd_vel', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        command = Twist()
        try:
            found = self.buffer.lookup_transform(self.me, self.leader, Time())
            age = self.get_clock().now() - Time.from_msg(found.header.stamp)
            if age <= Duration(seconds=0.15):
                command = chase(found.transform.translation.x, found.transform.translation.y)
        except TransformException:
            pass
        self.motor.publish(command)
