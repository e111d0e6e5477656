# attack: makes hundreds of topics and services
# row: 24
# aims at: 90.3
# stopped by: waits are bounded
# expect verdict: failed or timeout or learner_crashed
# expect message: messages came or did not return or raised
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.many = [self.create_publisher(String, f'topic{number}', 10) for number in range(300)]
