# expect: never comes to rest
# rejected by: test_bridge
# Exercise 1.3: prove it, and break it
def who_hears(speaker, listeners, seconds=3.0):
    heard = set()
    nodes = {domain: join(domain, 'listener') for domain in listeners}
    for domain, node in nodes.items():
        node.create_subscription(String, 'roll_call', lambda msg, domain=domain: heard.add(domain), 10)
    source = join(speaker, 'speaker')
    publisher = source.create_publisher(String, 'roll_call', 10)
    end = time.monotonic() + seconds
    while len(heard) < len(nodes) and time.monotonic() < end:
        publisher.publish(String(data='hello'))
        for node in nodes.values():
            spin_for(0.02, node)
    for node in [source, *nodes.values()]:
        leave(node)
    return sorted(heard)


class Bridge(Node):
    def __init__(self, other_domain):
        super().__init__('bridge')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_subscription(String, 'chatter', self.publisher.publish, 10)
