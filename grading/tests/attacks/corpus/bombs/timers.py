# attack: makes many timers of a nanosecond
# row: 14
# aims at: 90.3
# stopped by: the number of callbacks at one moment, and of moments, is bounded
# expect verdict: failed
# expect message: very small period or never comes to rest
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.many = [self.create_timer(1e-9, lambda: None) for _ in range(50)]
