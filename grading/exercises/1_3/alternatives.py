from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('carries_in_a_timer', old="""
        self.create_subscription(String, 'chatter', self.publisher.publish, 10)
        """, new="""
        waiting = []

        def carry():
            while waiting:
                self.publisher.publish(waiting.pop(0))

        self.create_subscription(String, 'chatter', waiting.append, 10)
        self.create_timer(0.1, carry)
        """),
    Alternative('background', source='''
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
'''),
    Alternative('executors', source='''
from rclpy.executors import SingleThreadedExecutor


def who_hears(speaker, listeners, seconds=3.0):
    heard, hands = [], []
    source = rclpy.Context()
    source.init(domain_id=speaker)
    speaking = Node('speaker', context=source)
    publisher = speaking.create_publisher(String, 'roll_call', 10)
    for domain in listeners:
        context = rclpy.Context()
        context.init(domain_id=domain)
        node = Node(f'listener_{domain}', context=context)
        node.create_subscription(String, 'roll_call', lambda msg, d=domain: heard.append(d), 10)
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)
        hands.append((executor, node, context))
    end = time.monotonic() + seconds
    while set(heard) != set(listeners) and time.monotonic() < end:
        publisher.publish(String(data='anybody?'))
        for executor, _, _ in hands:
            executor.spin_once(timeout_sec=0.01)
    for executor, node, context in hands:
        executor.shutdown()
        node.destroy_node()
        context.shutdown()
    speaking.destroy_node()
    source.shutdown()
    return sorted(set(heard))


class Bridge(Node):
    def __init__(self, other_domain):
        super().__init__('bridge')
        self.context_there = rclpy.Context()
        self.context_there.init(domain_id=other_domain)
        self.there = Node('bridge', context=self.context_there)
        self.mouth = self.there.create_publisher(String, 'chatter', 10)
        self.ear = self.create_subscription(String, 'chatter', self.on_chatter, 10)

    def on_chatter(self, msg):
        self.mouth.publish(String(data=msg.data))
'''),
    Alternative('exit_stack_and_coroutine', source='''
from contextlib import ExitStack, contextmanager
from functools import partial


@contextmanager
def present(domain, name):
    node = join(domain, name)
    try:
        yield node
    finally:
        leave(node)


def who_hears(speaker, listeners, seconds=3.0):
    ears = {}
    with ExitStack() as stack:
        for domain in listeners:
            node = stack.enter_context(present(domain, f'ear_{domain}'))
            node.create_subscription(String, 'roll_call', partial(ears.__setitem__, domain), 10)
            ears[domain] = None
            stack.enter_context(spinning(node))
        say = stack.enter_context(present(speaker, 'mouth')).create_publisher(String, 'roll_call', 10).publish
        end = time.monotonic() + seconds
        while None in ears.values() and time.monotonic() < end:
            say(String(data='who is there?'))
            time.sleep(0.02)
        return sorted(domain for domain, word in ears.items() if word)


class Bridge(Node):
    def __init__(self, other_domain):
        super().__init__('bridge')
        self.far = join(other_domain, 'bridge')
        self.say = self.far.create_publisher(String, 'chatter', 10).publish
        self.create_subscription(String, 'chatter', self.carry, 10)

    async def carry(self, message):
        self.say(message)
'''),
]
