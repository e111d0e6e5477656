# attack: publishes a /clock of its own
# row: 20
# aims at: 90.3
# stopped by: the tests keep their own time, and say which moment each message came in
# expect verdict: failed or timeout
# expect message: messages came or never comes to rest or did not return
from rosgraph_msgs.msg import Clock


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.clock_publisher = self.create_publisher(Clock, '/clock', 10)
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.count = 0
        self.create_timer(0.5, self.tick)

    def tick(self):
        message = Clock()
        message.clock.sec = 10**6 + self.count
        self.clock_publisher.publish(message)
        for _ in range(2):
            self.publisher.publish(String(data=f'n{self.count}'))
            self.count += 1
