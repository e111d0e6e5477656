# attack: answers its own messages without end
# row: 14
# aims at: 90.3
# stopped by: the number of callbacks at one moment is bounded
# expect verdict: failed
# expect message: never comes to rest
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_subscription(String, 'chatter', self.publisher.publish, 10)
        self.publisher.publish(String(data='n0'))
