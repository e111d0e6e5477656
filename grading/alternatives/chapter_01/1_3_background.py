# Exercise 1.3: prove it, and break it
def who_hears(speaker, listeners, seconds=3.0):
    heard = {domain: [] for domain in listeners}
    listening = []
    for domain in heard:
        node = join(domain, 'ear')
        node.create_subscription(String, 'roll_call', heard[domain].append, 10)
        listening.append((node, spinning(node)))
    source = join(speaker, 'mouth')
    publisher = source.create_publisher(String, 'roll_call', 10)

    def all_have_heard():
        publisher.publish(String(data='hello'))
        return all(heard.values())

    try:
        wait_for(all_have_heard, timeout=seconds)
    except TimeoutError:
        pass
    for node, handle in listening:
        handle.stop()
        rclpy.shutdown(context=node.context)
    leave(source)
    return sorted(domain for domain in heard if heard[domain])


class Bridge(Node):
    def __init__(self, other_domain):
        super().__init__('bridge')
        self.other_side = join(other_domain, 'bridge')
        publisher = self.other_side.create_publisher(String, 'chatter', 10)
        self.create_subscription(String, 'chatter', lambda msg: publisher.publish(msg), 10)
