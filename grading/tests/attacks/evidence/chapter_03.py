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
