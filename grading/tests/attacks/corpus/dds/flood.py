# attack: publishes from a thread as fast as it can
# row: 19
# aims at: 90.3
# stopped by: the number of messages that a test takes is bounded
# expect verdict: failed or timeout
# expect message: messages
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 1000)
        threading.Thread(target=self.flood, daemon=True).start()

    def flood(self):
        end = time.monotonic() + 60
        while time.monotonic() < end:
            self.publisher.publish(String(data='n0'))
