# expect: The second goal was rejected
# rejected by: test_newest_wins
# Exercise 5.3: the newest goal wins
class NewestWins(Node):
    def __init__(self):
        super().__init__('newest_wins')
        self.newest = None
        self.server = ActionServer(
            self, Fibonacci, 'count', self.execute, goal_callback=self.on_goal,
            handle_accepted_callback=self.on_accepted,
            cancel_callback=lambda goal: CancelResponse.ACCEPT)

    def on_goal(self, request):
        return GoalResponse.ACCEPT if request.order >= 1 and (self.newest is None or not self.newest.is_active) else GoalResponse.REJECT

    def on_accepted(self, goal):
        self.newest = goal
        goal.execute()

    def execute(self, goal):
        numbers = []
        while len(numbers) < goal.request.order:
            self.get_clock().sleep_for(Duration(seconds=0.5))
            if goal.is_cancel_requested or goal is not self.newest:
                goal.canceled() if goal.is_cancel_requested else goal.abort()
                return Fibonacci.Result(sequence=numbers)
            numbers.append(len(numbers) + 1)
            goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
        goal.succeed()
        return Fibonacci.Result(sequence=numbers)
