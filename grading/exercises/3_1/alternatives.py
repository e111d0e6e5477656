from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('explicit_qos', source='''
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy

RATE = 4  # Hz


class Beacon(Node):
    count = 0  # only the first value; += makes an attribute of the object

    def __init__(self):
        super().__init__('beacon')
        profile = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=10, reliability=ReliabilityPolicy.RELIABLE)
        publisher = self.create_publisher(String, 'beacon', profile)
        self.create_timer(1.0 / RATE, lambda: publisher.publish(self.next_text()))

    def next_text(self):
        self.count += 1
        text = String()
        text.data = 'alive ' + str(self.count)
        return text
'''),
    Alternative('function', source='''
import itertools


def Beacon():
    node = rclpy.create_node('beacon')
    publisher = node.create_publisher(String, 'beacon', 10)
    numbers = itertools.count(1)

    def tell():
        publisher.publish(String(data='alive %d' % next(numbers)))

    node.create_timer(1 / 4, tell)
    return node
'''),
    Alternative('thread_with_a_rate', source='''
import threading


class Beacon(Node):
    """A thread of its own sleeps on a rate."""

    def __init__(self):
        super().__init__('beacon')
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.rate = self.create_rate(4.0)
        threading.Thread(target=self.work, daemon=True).start()

    def work(self):
        count = 0
        while rclpy.ok():
            self.rate.sleep()
            count += 1
            self.publisher.publish(String(data=f'alive {count}'))
'''),
]
