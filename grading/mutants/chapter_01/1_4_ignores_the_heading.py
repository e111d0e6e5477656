# expect: round and round
# rejected by: test_any_goal
# Exercise 1.4: drive the turtle to a goal
class GoToGoal(Node):
    def __init__(self, x, y):
        super().__init__('go_to_goal')
        self.x, self.y = x, y
        self.wheel = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.create_subscription(Pose, 'turtle1/pose', self.on_pose, 10)

    def on_pose(self, pose):
        dx, dy = self.x - pose.x, self.y - pose.y
        distance = math.hypot(dx, dy)
        error = math.remainder(math.atan2(dy, dx), 2 * math.pi)
        command = Twist()
        if distance > 0.05:
            command.angular.z = 3.0 * error
            if abs(error) < 0.3:
                command.linear.x = min(1.5 * distance, 2.0)
        self.wheel.publish(command)
