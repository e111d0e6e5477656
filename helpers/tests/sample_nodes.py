"""Nodes that the tests spin."""

from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    """Publishes on /chatter every 0.02 s."""

    def __init__(self, name='talker', **options):
        super().__init__(name, **options)
        self.count = 0
        self.publisher = self.create_publisher(String, '/chatter', 10)
        self.create_timer(0.02, self.tick)

    def tick(self):
        self.count += 1
        self.publisher.publish(String(data=f'hello {self.count}'))


class Listener(Node):
    """Keeps what comes on /chatter."""

    def __init__(self, name='listener', **options):
        super().__init__(name, **options)
        self.heard = []
        self.create_subscription(String, '/chatter', self.hear, 10)

    def hear(self, message):
        self.heard.append(message.data)


class Faulty(Talker):
    """A talker whose callback raises at every tick after the third."""

    def __init__(self, name='faulty', **options):
        super().__init__(name, **options)

    def tick(self):
        super().tick()
        if self.count > 3:
            raise ValueError('no voice')
