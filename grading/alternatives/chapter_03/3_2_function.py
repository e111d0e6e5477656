# Exercise 3.2: from centimetres to metres
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
