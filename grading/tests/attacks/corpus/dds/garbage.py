# attack: publishes bytes that are no message, and texts that are no UTF-8
# row: 19
# aims at: 90.3
# stopped by: what cannot be read is not taken for a message, and is the learner's fault
# expect verdict: failed or learner_crashed
# expect message: messages came or cannot be read
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, self.tick)

    def tick(self):
        for data in (b'', b'\x00', b'\x00\x01\x00\x00', b'\x00\x01\x00\x00\xff\xff\xff\xff', b'\xff' * 100,
                     b'\x00\x01\x00\x00\x04\x00\x00\x00\xff\xfe\xfd\x00'):
            self.publisher.publish(data)
