# expect: The turtle stood at its goal
# rejected by: test_at_the_goal_already
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
        error = math.remainder(math.atan2(dy, dx) - pose.theta, 2 * math.pi)
        command = Twist()
        command.angular.z = 3.0 * error
        command.linear.x = 0.5
        self.wheel.publish(command)
