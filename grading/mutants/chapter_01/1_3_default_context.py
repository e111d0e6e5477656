# expect: No speaker
# rejected by: test_it_speaks_in_the_domain
# Exercise 1.3: prove it, and break it
def who_hears(speaker, listeners, seconds=3.0):
    heard = set()
    nodes = {domain: join(domain, 'listener') for domain in listeners}
    for domain, node in nodes.items():
        node.create_subscription(String, 'roll_call', lambda msg, domain=domain: heard.add(domain), 10)
    rclpy.init(domain_id=speaker)
    source = rclpy.create_node('speaker')
    publisher = source.create_publisher(String, 'roll_call', 10)
    end = time.monotonic() + seconds
    while len(heard) < len(nodes) and time.monotonic() < end:
        publisher.publish(String(data='hello'))
        for node in nodes.values():
            spin_for(0.02, node)
    source.destroy_node()
    for node in nodes.values():
        leave(node)
    return sorted(heard)


class Bridge(Node):
    def __init__(self, other_domain):
        super().__init__('bridge')
        self.other_side = join(other_domain, 'bridge')
        self.publisher = self.other_side.create_publisher(String, 'chatter', 10)
        self.create_subscription(String, 'chatter', self.publisher.publish, 10)
