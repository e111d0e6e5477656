# expect: did not return
# rejected by: test_first_message
# Exercise 3.1: a beacon
import time


class Beacon(Node):
    def __init__(self):
        super().__init__('beacon')
        self.count = 0
        self.publisher = self.create_publisher(String, 'beacon', 10)
        while True:
            self.on_timer()
            time.sleep(0.25)

    def on_timer(self):
        self.count += 1
        self.publisher.publish(String(data=f'alive {self.count}'))
