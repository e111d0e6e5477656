# attack: publishes messages of 100 MB
# row: 19
# aims at: 90.3
# stopped by: memory is bounded on both sides
# expect verdict: failed or learner_crashed or timeout or grader_error
# expect message: messages came or raised or did not return or process
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, lambda: self.publisher.publish(String(data='x' * 100_000_000)))
