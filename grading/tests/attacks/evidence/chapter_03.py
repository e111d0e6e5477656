"""Attacks on what counts as evidence, in exercises of chapter 3. See ../README.md for the form of a row."""


# %% beacon_elsewhere
# attack: speaks in all ROS domains, under the names of the tests' nodes, and asks for their parameters
# aims at: 3.1
# stopped by: the network holds the submission and its tests only; other participants are seen
import threading

import rclpy
from rclpy.context import Context
from rclpy.node import Node
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import String


def speak(domain):
    context = Context()
    rclpy.init(context=context, domain_id=domain)
    node = rclpy.create_node('beacon', context=context)
    publisher = node.create_publisher(String, 'beacon', 10)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    node.create_timer(0.5, lambda: publisher.publish(String(data='robot 1 here')))
    executor.spin()


for number in range(0, 6):
    threading.Thread(target=speak, args=(number,), daemon=True).start()


class Beacon(Node):
    def __init__(self):
        super().__init__('beacon')


# %% name_said
# attack: says that it has another name than the graph shows
# aims at: 3.1
# stopped by: a method of its own class is not asked for its name
# may keep: topic, qos, rate, first, texts, own-count, at-once
class Beacon(Node):
    def __init__(self):
        super().__init__('lighthouse')
        self.count = 0
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.create_timer(0.25, self.on_timer)

    def get_fully_qualified_name(self):
        return super().get_fully_qualified_name().replace('lighthouse', 'beacon')

    def on_timer(self):
        self.count += 1
        self.publisher.publish(String(data=f'alive {self.count}'))


# %% name_patched
# attack: has every node say that it has the right name
# aims at: 3.1
# stopped by: a name counts only if the graph has it
# may keep: topic, qos, rate, first, texts, own-count, at-once
Node.get_fully_qualified_name = lambda self: '/robot/beacon'


class Beacon(Node):
    def __init__(self):
        super().__init__('lighthouse')
        self.count = 0
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.create_timer(0.25, self.on_timer)

    def on_timer(self):
        self.count += 1
        self.publisher.publish(String(data=f'alive {self.count}'))


# %% qos_behind_the_conductor
# attack: speaks by a node that is called as the tests' own one in its process, with another QoS, beside a publisher that is silent
# aims at: 3.1
# stopped by: whose an endpoint is, its participant says, and no name
# may keep: rate, first, texts, own-count, at-once
import time

from rclpy.qos import DurabilityPolicy, QoSProfile


class Beacon(Node):
    def __init__(self):
        super().__init__('beacon')
        self.count = 0
        self.decoy = self.create_publisher(String, 'beacon', 10)
        names = [name for name in self.get_node_names() if name.startswith('_') and not name.endswith('_t')]
        self.hidden = Node(names[0] if names else '_x', start_parameter_services=False, enable_rosout=False)
        self.publisher = self.hidden.create_publisher(
            String, 'beacon', QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        self.create_timer(0.25, self.on_timer)

    def on_timer(self):
        self.count += 1
        self.publisher.publish(String(data=f'alive {self.count}'))


# %% speaks_besides
# attack: says more than is asked for, by a node with a hidden name; two of them do answer one message each
# aims at: 3.2
# stopped by: publishers are looked for by their participant
# may keep: node, topics, qos, one-each, at-once, distances, variance, header, others, inf
from sensor_msgs.msg import Range


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.other = Node('_other')
        self.more = self.other.create_publisher(Range, 'more', 10)
        self.subscription = self.create_subscription(Range, 'sonar_cm', self.on_range, 10)

    def on_range(self, msg):
        msg.range /= 100
        msg.min_range /= 100
        msg.max_range /= 100
        msg.variance /= 100**2
        self.publisher.publish(msg)
        self.more.publish(msg)
