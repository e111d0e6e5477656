# expect: share one counter
# rejected by: test_two_beacons
# Exercise 3.1: a beacon
class Beacon(Node):
    count = 0

    def __init__(self):
        super().__init__('beacon')
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.timer = self.create_timer(0.25, self.on_timer)

    def on_timer(self):
        Beacon.count += 1
        self.publisher.publish(String(data=f'alive {Beacon.count}'))
