# attack: makes thousands of timers of a nanosecond
# row: 14
# aims at: 90.3
# stopped by: the number of callbacks at one moment is bounded
# expect verdict: failed or timeout or learner_crashed
# expect message: never comes to rest or did not return or raised or messages
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.many = [self.create_timer(1e-9, lambda: None) for _ in range(500)]
