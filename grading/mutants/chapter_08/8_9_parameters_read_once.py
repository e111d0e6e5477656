# expect: max_linear was set to
# rejected by: test_parameters
# alone: its exercise uses the answers of others
# Exercise 8.9: go to a station
class DeliveryRobot(Courier):
    def __init__(self, **options):
        super().__init__(**options)
        self.limits = self.value('max_linear'), self.value('max_angular')
        self.server = ActionServer(self, GoToStation, 'go_to_station', self.execute, goal_callback=self.on_goal,
                                   cancel_callback=lambda goal: CancelResponse.ACCEPT)

    def on_goal(self, request):
        if self.state != 'idle' or self.place(request.station) is None or self.where() is None:
            return GoalResponse.REJECT
        self.state = f'driving to {request.station}'
        return GoalResponse.ACCEPT

    def execute(self, goal):
        place, step, distance, end = self.place(goal.request.station), 0, -1.0, None
        while end is None:
            self.get_clock().sleep_for(Duration(seconds=0.1))
            step, pose = step + 1, self.where()
            if pose:
                distance, *velocity = steer(*pose, *place, *self.limits)
            if goal.is_cancel_requested:
                end, why = goal.canceled, 'cancelled'
            elif pose is None:
                end, why = goal.abort, 'the robot is lost'
            elif distance < self.value('tolerance'):
                end, why = goal.succeed, 'arrived'
            elif 0.1 * step >= self.value('timeout'):
                end, why = goal.abort, 'it took too long'
            else:
                self.drive(*velocity)
            if step % 4 == 0:
                goal.publish_feedback(GoToStation.Feedback(distance=distance))
        self.drive(0.0, 0.0)
        self.state = 'idle'
        end()
        return GoToStation.Result(distance=distance, message=why)
