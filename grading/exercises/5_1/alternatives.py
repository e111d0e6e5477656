from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('awaits_a_timer', source='''
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
'''),
    Alternative('looks_often', source='''
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
'''),
    Alternative('destroys_its_timer', edits=(('def execute(self, goal):', 'async def execute(self, goal):'),
            ('self.get_clock().sleep_for(Duration(seconds=0.5))', '''
            tick = rclpy.task.Future()
            timer = self.create_timer(0.5, lambda: tick.done() or tick.set_result(None))
            await tick
            timer.destroy()
            '''))),
    Alternative('rate', edits=(('numbers = []', 'numbers, rate = [], self.create_rate(2.0)'),
            ('self.get_clock().sleep_for(Duration(seconds=0.5))', 'rate.sleep()'))),
    Alternative('results_for_a_second', old='cancel_callback=', new='result_timeout=1, cancel_callback='),
    Alternative('results_for_no_time', old='cancel_callback=', new='result_timeout=0, cancel_callback='),
]
