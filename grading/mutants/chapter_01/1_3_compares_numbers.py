# expect: does it compare numbers
# rejected by: test_it_measures
# Exercise 1.3: prove it, and break it
def who_hears(speaker, listeners, seconds=3.0):
    source = join(speaker, 'speaker')
    publisher = source.create_publisher(String, 'roll_call', 10)
    for _ in range(20):
        publisher.publish(String(data='hello'))
        time.sleep(0.02)
    leave(source)
    return sorted(domain for domain in listeners if domain == speaker)


class Bridge(Node):
    def __init__(self, other_domain):
        super().__init__('bridge')
        self.other_side = join(other_domain, 'bridge')
        self.publisher = self.other_side.create_publisher(String, 'chatter', 10)
        self.create_subscription(String, 'chatter', self.publisher.publish, 10)
