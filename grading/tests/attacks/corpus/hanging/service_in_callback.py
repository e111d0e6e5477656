# attack: waits in a callback for a service that nobody offers
# row: 14
# aims at: 90.3
# stopped by: each step is waited for within a bound
# expect verdict: timeout
# expect message: A callback must return at once
from rcl_interfaces.srv import GetParameters


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.client = self.create_client(GetParameters, 'nobody')
        self.create_timer(0.5, self.tick)

    def tick(self):
        self.client.wait_for_service()
