# expect: only an accepted goal takes over
# rejected by: test_rejected_goals_disturb_nobody
# Exercise 5.3: the newest goal wins
class NewestWins(Node):
    def __init__(self):
        super().__init__('newest_wins')
        self.newest, self.number, self.mine = None, 0, {}
        self.server = ActionServer(
            self, Fibonacci, 'count', self.execute, goal_callback=self.on_goal,
            handle_accepted_callback=self.on_accepted,
            cancel_callback=lambda goal: CancelResponse.ACCEPT)

    def on_goal(self, request):
        self.number += 1
        return GoalResponse.ACCEPT if request.order >= 1 else GoalResponse.REJECT

    def on_accepted(self, goal):
        self.mine[bytes(goal.goal_id.uuid)] = self.number
        goal.execute()

    def execute(self, goal):
        numbers = []
        while len(numbers) < goal.request.order:
            self.get_clock().sleep_for(Duration(seconds=0.5))
            if goal.is_cancel_requested or self.mine[bytes(goal.goal_id.uuid)] != self.number:
                goal.canceled() if goal.is_cancel_requested else goal.abort()
                return Fibonacci.Result(sequence=numbers)
            numbers.append(len(numbers) + 1)
            goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
        goal.succeed()
        return Fibonacci.Result(sequence=numbers)
