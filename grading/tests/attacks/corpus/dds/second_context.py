# attack: speaks through a participant of its own beside the one that the tests know
# row: 21
# aims at: 90.3
# stopped by: only the participants of the programs that the tests started may publish to them
# expect verdict: failed
# expect message: another program or messages came
from rclpy.context import Context


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        prefix = self.declare_parameter('prefix', 'n').value
        self.other = Context()
        self.other.init()
        self.node = Node('talker', context=self.other)
        publisher = self.node.create_publisher(String, 'chatter', 10)
        count = iter(range(100))
        self.create_timer(0.5, lambda: publisher.publish(String(data=f'{prefix}{next(count)}')))
