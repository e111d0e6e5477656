# expect: and where() says
# rejected by: test_yaw
# Exercise 8.8: where am I?
class Courier(StationKeeper):
    def __init__(self, **options):
        super().__init__(**options)
        self.motor = self.create_publisher(Twist, 'cmd_vel', 10)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)

    def drive(self, linear, angular):
        command = Twist()
        command.linear.x, command.angular.z = linear, angular
        self.motor.publish(command)

    def where(self):
        try:
            found = self.buffer.lookup_transform('map', 'base_footprint', Time())
        except TransformException:
            return None
        if self.get_clock().now() - Time.from_msg(found.header.stamp) > Duration(seconds=0.5):
            return None
        place, turn = found.transform.translation, found.transform.rotation
        return place.x, place.y, turn.z
