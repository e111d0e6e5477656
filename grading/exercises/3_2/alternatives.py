from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('function', source='''
from copy import deepcopy

from sensor_msgs.msg import Range

FACTORS = {'range': 0.01, 'min_range': 0.01, 'max_range': 0.01, 'variance': 0.0001}


def RangeToMetres():
    node = Node('range_to_metres')
    publisher = node.create_publisher(Range, 'sonar', 10)

    def relay(message):
        result = deepcopy(message)
        for field, factor in FACTORS.items():
            setattr(result, field, getattr(message, field) * factor)
        publisher.publish(result)

    node.create_subscription(Range, 'sonar_cm', relay, 10)
    return node
'''),
    Alternative('new_message', source='''
METRE = 100.0  # cm


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.out = self.create_publisher(Range, 'sonar', 10)
        self.create_subscription(Range, 'sonar_cm', lambda msg: self.out.publish(self.converted(msg)), 10)

    @staticmethod
    def converted(msg):
        return Range(header=msg.header, radiation_type=msg.radiation_type, field_of_view=msg.field_of_view,
                     min_range=msg.min_range / METRE, max_range=msg.max_range / METRE, range=msg.range / METRE,
                     variance=msg.variance / METRE / METRE)
'''),
    Alternative('a_thread_publishes', source="""
import queue
import threading

from sensor_msgs.msg import Range


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.waiting = queue.Queue()
        self.create_subscription(Range, 'sonar_cm', self.waiting.put, 10)
        threading.Thread(target=self.work, daemon=True).start()

    def work(self):
        while True:
            msg = self.waiting.get()
            msg.range, msg.min_range, msg.max_range = msg.range / 100, msg.min_range / 100, msg.max_range / 100
            msg.variance /= 10000
            self.publisher.publish(msg)
"""),
]
