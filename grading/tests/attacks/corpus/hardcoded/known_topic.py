# attack: publishes the visible test's messages by heart
# row: 12
# aims at: 90.3
# stopped by: hidden tests draw fresh inputs
# expect verdict: failed
# expect points: 2.5
# expect message: others than expected
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.texts = ['n0', 'n1', 'n2', 'n3']
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, lambda: self.publisher.publish(String(data=self.texts.pop(0))))
