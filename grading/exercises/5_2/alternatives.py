from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('coroutine', source='''
from action_msgs.msg import GoalStatus
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup


class PatientClient(Node):
    """One coroutine tells the whole story; a timer breaks its waits."""

    def __init__(self, order, patience):
        super().__init__('patient_client')
        self.goal = Fibonacci.Goal(order=order)
        self.patience = patience
        self.last = []
        self.publisher = self.create_publisher(String, 'outcome', 10)
        self.client = ActionClient(self, Fibonacci, 'fibonacci')
        self.looking = self.create_timer(0.1, self.look, callback_group=MutuallyExclusiveCallbackGroup())

    async def look(self):
        if not self.client.server_is_ready():
            return
        self.looking.cancel()
        handle = await self.client.send_goal_async(self.goal, feedback_callback=self.on_feedback)
        if not handle.accepted:
            return self.tell('rejected', [])
        result = handle.get_result_async()
        if not await self.within(result, self.patience):
            if not await self.within(handle.cancel_goal_async(), 1.0):
                return self.tell('lost', self.last)
        answer = await result
        self.tell({GoalStatus.STATUS_SUCCEEDED: 'succeeded', GoalStatus.STATUS_CANCELED: 'canceled',
                   GoalStatus.STATUS_ABORTED: 'aborted'}[answer.status], answer.result.sequence)

    async def within(self, future, seconds):
        first = rclpy.task.Future()
        timer = self.create_timer(seconds, lambda: first.done() or first.set_result(False))
        future.add_done_callback(lambda _: first.done() or first.set_result(True))
        came = await first
        self.destroy_timer(timer)
        return came

    def on_feedback(self, message):
        self.last = message.feedback.sequence

    def tell(self, word, numbers):
        self.publisher.publish(String(data=f'{word} {[int(number) for number in numbers]}'))
'''),
    Alternative('three_timers', source='''
class PatientClient(Node):
    def __init__(self, order, patience):
        super().__init__('patient_client')
        self.order, self.seen, self.said = order, [], False
        self.outcome = self.create_publisher(String, 'outcome', 10)
        self.client = ActionClient(self, Fibonacci, 'fibonacci')
        self.looking = self.create_timer(0.1, self.look)
        self.deadline = self.create_timer(patience, self.give_up, autostart=False)
        self.silence = self.create_timer(1.0, self.lose, autostart=False)

    def look(self):
        if not self.client.server_is_ready():
            return
        self.looking.cancel()
        future = self.client.send_goal_async(Fibonacci.Goal(order=self.order), feedback_callback=self.seen.append)
        future.add_done_callback(lambda future: self.accepted(future.result()))

    def accepted(self, goal):
        if goal.accepted:
            self.mine = goal
            goal.get_result_async().add_done_callback(lambda future: self.ended(future.result()))
            self.deadline.reset()
        else:
            self.say('rejected', [])

    def give_up(self):
        self.deadline.cancel()
        self.silence.reset()
        self.mine.cancel_goal_async().add_done_callback(lambda _: self.silence.cancel())

    def lose(self):
        self.say('lost', self.seen[-1].feedback.sequence if self.seen else [])

    def ended(self, answer):
        self.say(STATUS[answer.status], answer.result.sequence)

    def say(self, word, numbers):
        self.deadline.cancel()
        self.silence.cancel()
        if not self.said:
            self.said = True
            self.outcome.publish(String(data=f'{word} {numbers.tolist() if len(numbers) else []}'))
'''),
]
