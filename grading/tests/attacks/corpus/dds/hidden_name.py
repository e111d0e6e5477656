# attack: names its second node like one of the tests' own, so that it is not counted
# row: 21
# aims at: 90.3
# stopped by: endpoints are told apart by participant, not by name
# expect verdict: failed
# expect message: another program or messages came
from rclpy.context import Context


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        prefix = self.declare_parameter('prefix', 'n').value
        tests = next((name for name in self.get_node_names() if name.endswith('_t')), '_x_t')
        self.other = Context()
        self.other.init()
        self.node = Node(tests, context=self.other)
        publisher = self.node.create_publisher(String, 'chatter', 10)
        count = iter(range(100))
        self.create_timer(0.5, lambda: publisher.publish(String(data=f'{prefix}{next(count)}')))
