# expect: No turtle can get there
# rejected by: test_outside
# Exercise 5.4: drive to a place
class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.pose, self.busy = None, False
        self.motor = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.create_subscription(Pose, 'turtle1/pose', self.on_pose, 10)
        self.server = ActionServer(
            self, DriveTo, 'drive_to', self.execute, goal_callback=self.on_goal,
            cancel_callback=lambda goal: CancelResponse.ACCEPT)

    def on_pose(self, pose):
        self.pose = pose

    def on_goal(self, request):
        inside = True
        if self.busy or self.pose is None or not inside:
            return GoalResponse.REJECT
        self.busy = True
        return GoalResponse.ACCEPT

    def execute(self, goal):
        for step in range(1, 201):
            self.get_clock().sleep_for(Duration(seconds=0.1))
            distance, command = steer(self.pose, goal.request.x, goal.request.y)
            if goal.is_cancel_requested or distance < 0.1:
                break
            self.motor.publish(command)
            if step % 2 == 0:
                goal.publish_feedback(DriveTo.Feedback(distance=distance))
        self.motor.publish(Twist())
        self.busy = False
        end = goal.canceled if goal.is_cancel_requested else goal.succeed if distance < 0.1 else goal.abort
        end()
        return DriveTo.Result(distance=distance)
