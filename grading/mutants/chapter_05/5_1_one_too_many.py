# expect: expected the first five numbers
# rejected by: test_orders
# told by: test_numbers
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
        while len(numbers) <= goal.request.order:
            self.get_clock().sleep_for(Duration(seconds=0.5))
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=numbers)
            numbers.append(sum(numbers[-2:]) if len(numbers) > 1 else len(numbers))
            goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
        goal.succeed()
        return Fibonacci.Result(sequence=numbers)
