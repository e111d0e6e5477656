# Exercise 3.1: a beacon
import itertools


def Beacon():
    node = rclpy.create_node('beacon')
    publisher = node.create_publisher(String, 'beacon', 10)
    numbers = itertools.count(1)

    def tell():
        publisher.publish(String(data='alive %d' % next(numbers)))

    node.create_timer(1 / 4, tell)
    return node
