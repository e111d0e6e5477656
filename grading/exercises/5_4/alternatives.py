from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('rate_and_clock', source='''
import threading


class Driver(Node):
    """A rate, a deadline on the clock, and a lock that is never waited for."""

    def __init__(self):
        super().__init__('driver')
        self.pose = None
        self.one = threading.Lock()
        self.motor = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.create_subscription(Pose, 'turtle1/pose', self.on_pose, 10)
        self.server = ActionServer(
            self, DriveTo, 'drive_to', self.execute, goal_callback=self.on_goal, cancel_callback=self.on_cancel)

    def on_pose(self, pose):
        self.pose = pose

    def on_cancel(self, goal):
        return CancelResponse.ACCEPT

    def on_goal(self, request):
        inside = all(0 <= value <= 11 for value in (request.x, request.y))
        free = inside and self.pose is not None and self.one.acquire(blocking=False)
        return GoalResponse.ACCEPT if free else GoalResponse.REJECT

    def execute(self, goal):
        rate = self.create_rate(10.0)
        end = self.get_clock().now() + Duration(seconds=20.0)
        told = self.get_clock().now()
        while True:
            rate.sleep()
            distance, command = steer(self.pose, goal.request.x, goal.request.y)
            if goal.is_cancel_requested or distance < 0.1 or self.get_clock().now() >= end:
                break
            self.motor.publish(command)
            if self.get_clock().now() - told >= Duration(seconds=0.3):
                told = self.get_clock().now()
                goal.publish_feedback(DriveTo.Feedback(distance=distance))
        rate.destroy()
        self.motor.publish(Twist())
        self.one.release()
        if goal.is_cancel_requested:
            goal.canceled()
        elif distance < 0.1:
            goal.succeed()
        else:
            goal.abort()
        return DriveTo.Result(distance=distance)
'''),
    Alternative('timer_drives', source='''
class Driver(Node):
    """A timer drives; execute only waits for it, without a thread."""

    def __init__(self):
        super().__init__('driver')
        self.pose = self.goal = self.taken = None
        self.create_subscription(Pose, 'turtle1/pose', lambda pose: setattr(self, 'pose', pose), 10)
        self.motor = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.server = ActionServer(
            self, DriveTo, 'drive_to', self.execute, goal_callback=self.on_goal,
            cancel_callback=lambda goal: CancelResponse.ACCEPT)

    def on_goal(self, request):
        if self.taken or self.pose is None or not (0 <= request.x <= 11 and 0 <= request.y <= 11):
            return GoalResponse.REJECT
        self.taken = True
        return GoalResponse.ACCEPT

    async def execute(self, goal):
        self.goal, self.rounds, self.over = goal, 0, rclpy.task.Future()
        timer = self.create_timer(0.1, self.drive)
        distance = await self.over
        self.destroy_timer(timer)
        self.taken = False
        return DriveTo.Result(distance=distance)

    def drive(self):
        if self.over.done():
            return
        self.rounds += 1
        distance, command = steer(self.pose, self.goal.request.x, self.goal.request.y)
        for reason, end in ((self.goal.is_cancel_requested, self.goal.canceled),
                            (distance < 0.1, self.goal.succeed), (self.rounds == 200, self.goal.abort)):
            if reason:
                self.motor.publish(Twist())
                end()
                self.over.set_result(distance)
                return
        self.motor.publish(command)
        if self.rounds % 3 == 0:
            self.goal.publish_feedback(DriveTo.Feedback(distance=distance))
'''),
    Alternative('feedback_twice_a_second', old='if step % 2 == 0:', new='if step % 5 == 1:'),
    Alternative('feedback_from_the_first_round_on', old='if step % 2 == 0:', new='if step % 4 == 1:'),
]
