# Exercise 5.2: a client with a deadline
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
