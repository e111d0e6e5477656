# Exercise 5.3: the newest goal wins
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
