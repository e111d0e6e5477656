from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('numbered', source='''
class NewestWins(Node):
    """Goals are numbered; a rate gives the rhythm."""

    def __init__(self):
        super().__init__('newest_wins')
        self.latest = b''
        self.server = ActionServer(self, Fibonacci, 'count', self.execute)
        self.server.register_goal_callback(
            lambda request: GoalResponse.REJECT if request.order < 1 else GoalResponse.ACCEPT)
        self.server.register_handle_accepted_callback(self.take_over)
        self.server.register_cancel_callback(lambda goal: CancelResponse.ACCEPT)

    def take_over(self, goal):
        self.latest = bytes(goal.goal_id.uuid)
        goal.execute()

    def execute(self, goal):
        result, rate = Fibonacci.Result(), self.create_rate(2.0)
        for number in range(1, goal.request.order + 1):
            rate.sleep()
            if goal.is_cancel_requested:
                goal.canceled()
                break
            if bytes(goal.goal_id.uuid) != self.latest:
                goal.abort()
                break
            result.sequence.append(number)
            goal.publish_feedback(Fibonacci.Feedback(sequence=result.sequence))
        else:
            goal.succeed()
        rate.destroy()
        return result
'''),
    Alternative('one_event_each', source='''
import threading


class NewestWins(Node):
    """Each goal has an event that tells it to end at once."""

    def __init__(self):
        super().__init__('newest_wins')
        self.lock = threading.Lock()
        self.running = None
        self.server = ActionServer(
            self, Fibonacci, 'count', self.execute, handle_accepted_callback=self.on_accepted,
            goal_callback=lambda request: GoalResponse.ACCEPT if request.order > 0 else GoalResponse.REJECT,
            cancel_callback=lambda goal: CancelResponse.ACCEPT)

    def on_accepted(self, goal):
        goal.replaced = threading.Event()
        with self.lock:
            if self.running is not None:
                self.running.replaced.set()
            self.running = goal
        goal.execute()

    def execute(self, goal):
        numbers = []
        tick = threading.Event()
        timer = self.create_timer(0.5, tick.set)
        try:
            while len(numbers) < goal.request.order:
                tick.wait()
                tick.clear()
                if goal.is_cancel_requested or goal.replaced.is_set():
                    goal.canceled() if goal.is_cancel_requested else goal.abort()
                    return Fibonacci.Result(sequence=numbers)
                numbers.append(len(numbers) + 1)
                goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
            goal.succeed()
            return Fibonacci.Result(sequence=numbers)
        finally:
            self.destroy_timer(timer)
'''),
]
