# expect: Report what the result says
# rejected by: test_cancel_in_vain
# Exercise 5.2: a client with a deadline
class PatientClient(Node):
    def __init__(self, order, patience):
        super().__init__('patient_client')
        self.order, self.patience, self.numbers = order, patience, []
        self.outcome = self.create_publisher(String, 'outcome', 10)
        self.client = ActionClient(self, Fibonacci, 'fibonacci')
        self.timer = self.create_timer(0.1, self.send)

    def send(self):
        if self.client.server_is_ready():
            self.timer.cancel()
            future = self.client.send_goal_async(Fibonacci.Goal(order=self.order), self.on_feedback)
            future.add_done_callback(self.on_answer)

    def on_feedback(self, message):
        self.numbers = message.feedback.sequence

    def on_answer(self, future):
        self.goal = future.result()
        if not self.goal.accepted:
            return self.finish('rejected', [])
        self.goal.get_result_async().add_done_callback(self.on_result)
        self.timer = self.create_timer(self.patience, self.give_up)

    def give_up(self):
        self.timer.cancel()
        self.timer = self.create_timer(1.0, lambda: self.finish('lost', self.numbers))
        self.goal.cancel_goal_async().add_done_callback(lambda future: self.timer.cancel())

    def on_result(self, future):
        gave_up = self.timer.is_canceled()
        self.finish('canceled' if gave_up else STATUS[future.result().status], future.result().result.sequence)

    def finish(self, word, numbers):
        self.timer.cancel()
        self.outcome.publish(String(data=f'{word} {list(numbers)}'))
