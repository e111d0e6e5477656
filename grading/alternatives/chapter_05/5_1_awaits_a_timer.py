# Exercise 5.1: a server that can be stopped
from rclpy.task import Future


class FibonacciServer(Node):
    """Awaits a timer: one thread would be enough."""

    def __init__(self):
        super().__init__('fibonacci_server')
        self.server = ActionServer(self, Fibonacci, 'fibonacci', self.execute)
        self.server.register_goal_callback(
            lambda request: GoalResponse.ACCEPT if request.order in range(48) else GoalResponse.REJECT)
        self.server.register_cancel_callback(lambda goal: CancelResponse.ACCEPT)

    async def execute(self, goal):
        numbers, a, b = [], 0, 1
        for _ in range(goal.request.order):
            await self.half_a_second()
            if goal.is_cancel_requested:
                break
            numbers.append(a)
            a, b = b, a + b
            goal.publish_feedback(Fibonacci.Feedback(sequence=list(numbers)))
        (goal.canceled if goal.is_cancel_requested else goal.succeed)()
        return Fibonacci.Result(sequence=numbers)

    async def half_a_second(self):
        done = Future()
        timer = self.create_timer(0.5, lambda: done.done() or done.set_result(None))
        await done
        self.destroy_timer(timer)
