# attack: loops without end in a timer
# row: 14
# aims at: 90.3
# stopped by: each step is waited for within a bound
# expect verdict: timeout
# expect message: A callback must return at once
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        while True:
            pass
