# Exercise 8.8: where am I?
from tf_transformations import euler_from_quaternion


class Courier(StationKeeper):
    def __init__(self, **options):
        super().__init__(**options)
        self.motor = self.create_publisher(Twist, 'cmd_vel', 10)
        self.tf = Buffer(node=self)
        self.tf_listener = TransformListener(self.tf, self)

    def drive(self, linear, angular):
        command = Twist()
        command.linear.x, command.angular.z = linear, angular
        self.motor.publish(command)

    def where(self):
        if not self.tf.can_transform('map', 'base_footprint', Time()):
            return None
        found = self.tf.lookup_transform('map', 'base_footprint', Time())
        stamp = found.header.stamp.sec + found.header.stamp.nanosec / 1e9
        if self.get_clock().now().nanoseconds / 1e9 - stamp > 0.5:
            return None
        turn = found.transform.rotation
        yaw = euler_from_quaternion((turn.x, turn.y, turn.z, turn.w))[2]
        return found.transform.translation.x, found.transform.translation.y, yaw
