# Exercise 1.4: drive the turtle to a goal
class GoToGoal(Node):
    def __init__(self, x, y):
        super().__init__('go_to_goal')
        self.goal = (x, y)
        self.pose = None
        self.wheel = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.create_subscription(Pose, 'turtle1/pose', self.on_pose, 10)
        self.create_timer(0.05, self.on_timer)

    def on_pose(self, pose):
        self.pose = pose

    def on_timer(self):
        if self.pose is None:
            return
        command = Twist()
        distance = math.dist(self.goal, (self.pose.x, self.pose.y))
        if distance > 0.06:
            direction = math.atan2(self.goal[1] - self.pose.y, self.goal[0] - self.pose.x)
            error = math.atan2(math.sin(direction - self.pose.theta), math.cos(direction - self.pose.theta))
            command.angular.z = max(-2.0, min(2.0, 2.0 * error))
            command.linear.x = min(1.0, distance) * max(0.0, math.cos(error)) ** 9
        self.wheel.publish(command)
