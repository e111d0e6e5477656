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
    Alternative('pure_function_and_match', source='''
from dataclasses import dataclass
from functools import partial


@dataclass(frozen=True)
class Goal:
    x: float
    y: float

    def seen_from(self, pose):
        to_goal = complex(self.x - pose.x, self.y - pose.y)
        ahead = to_goal * complex(math.cos(pose.theta), -math.sin(pose.theta))
        return abs(ahead), math.atan2(ahead.imag, ahead.real)


def decide(distance, error):
    match distance, abs(error):
        case far, _ if far < 0.06:
            return 0.0, 0.0
        case _, wrong if wrong > 0.2:
            return 0.0, math.copysign(min(2.5, 3 * wrong), error)
    return min(2.0, 1.5 * distance), 3 * error


class GoToGoal(Node):
    def __init__(self, x, y):
        super().__init__('go_to_goal')
        say = self.create_publisher(Twist, 'turtle1/cmd_vel', 10).publish
        self.create_subscription(Pose, 'turtle1/pose', partial(self.answer, Goal(x, y), say), 10)

    @staticmethod
    def answer(goal, say, pose):
        command = Twist()
        command.linear.x, command.angular.z = decide(*goal.seen_from(pose))
        say(command)
'''),
    Alternative('coroutine', edits=(('def on_pose', 'async def on_pose'),)),
]
