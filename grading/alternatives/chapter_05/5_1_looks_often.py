# Exercise 5.1: a server that can be stopped
class FibonacciServer(Node):
    """Looks ten times a second, so that it stops sooner; knows all numbers beforehand."""

    def __init__(self):
        super().__init__('fibonacci_server')
        self.all = [0, 1]
        while len(self.all) < 47:
            self.all.append(self.all[-1] + self.all[-2])
        self.server = ActionServer(
            self, Fibonacci, 'fibonacci', self.execute, cancel_callback=self.on_cancel, goal_callback=self.on_goal)

    def on_goal(self, request):
        if request.order < 0 or request.order > len(self.all):
            self.get_logger().warning(f'order {request.order} is rejected')
            return GoalResponse.REJECT
        return GoalResponse.ACCEPT

    def on_cancel(self, goal):
        return CancelResponse.ACCEPT

    def execute(self, goal):
        result = Fibonacci.Result()
        begin = self.get_clock().now()
        for tick in range(5 * goal.request.order):
            self.get_clock().sleep_until(begin + Duration(seconds=0.1 * (tick + 1)))
            if goal.is_cancel_requested:
                goal.canceled()
                return result
            if tick % 5 == 4:
                result.sequence = self.all[:tick // 5 + 1]
                goal.publish_feedback(Fibonacci.Feedback(sequence=result.sequence))
        goal.succeed()
        return result
