from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('states', source='''
class GoToGoal(Node):
    def __init__(self, x, y):
        super().__init__('go_to_goal')
        self.x, self.y, self.state = x, y, 'turn'
        self.wheel = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.create_subscription(Pose, 'turtle1/pose', self.on_pose, 10)

    def on_pose(self, pose):
        distance = ((self.x - pose.x) ** 2 + (self.y - pose.y) ** 2) ** 0.5
        error = math.atan2(self.y - pose.y, self.x - pose.x) - pose.theta
        while error > math.pi:
            error -= 2 * math.pi
        while error < -math.pi:
            error += 2 * math.pi
        if distance < 0.07:
            self.state = 'there'
        elif self.state == 'turn' and abs(error) < 0.03:
            self.state = 'drive'
        elif self.state == 'drive' and abs(error) > 0.4:
            self.state = 'turn'
        command = Twist()
        if self.state == 'turn':
            command.angular.z = 2.0 * error
        elif self.state == 'drive':
            command.linear.x = 0.9 if distance > 0.5 else 0.3
            command.angular.z = error
        self.wheel.publish(command)
'''),
    Alternative('timer', source='''
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
'''),
]
