# expect: expected canceled: ask is_cancel_requested in every step
# rejected by: test_cancel_at_any_step
# told by: test_cancel
# Exercise 5.1: a server that can be stopped
class FibonacciServer(Node):
    def __init__(self):
        super().__init__('fibonacci_server')
        self.server = ActionServer(
            self, Fibonacci, 'fibonacci', self.execute, goal_callback=self.on_goal,
            cancel_callback=lambda goal: CancelResponse.ACCEPT)

    def on_goal(self, request):
        return GoalResponse.ACCEPT if 0 <= request.order <= 47 else GoalResponse.REJECT

    def execute(self, goal):
        numbers = []
        while len(numbers) < goal.request.order:
            self.get_clock().sleep_for(Duration(seconds=0.5))
            numbers.append(sum(numbers[-2:]) if len(numbers) > 1 else len(numbers))
            goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
        goal.succeed()
        return Fibonacci.Result(sequence=numbers)
