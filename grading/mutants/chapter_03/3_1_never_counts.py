# expect: The text never changes
# rejected by: test_long_run
# told by: test_texts
# Exercise 3.1: a beacon
class Beacon(Node):
    def __init__(self):
        super().__init__('beacon')
        self.count = 1
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.timer = self.create_timer(0.25, self.on_timer)

    def on_timer(self):
        self.publisher.publish(String(data=f'alive {self.count}'))
