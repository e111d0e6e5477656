"""A program for the tests: broadcasts a chain of frames at 100 Hz, where each is a known function of the stamp."""

import math
import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

from environment.tests.tf2_messages import transform

DEPTH = 5


def where(nanoseconds):
    """Return the position and the rotation of every link at a time."""
    # Today's date in seconds is too large for a float to tell nanoseconds: a day and a bit is not.
    seconds = (nanoseconds % 10**14) / 1e9
    angle = 0.2 * math.sin(seconds)
    return (0.1 * seconds, 0.0, 0.0), (0.0, 0.0, math.sin(angle / 2), math.cos(angle / 2))


def main():
    """Broadcast until interrupted."""
    rclpy.init(args=sys.argv)
    node = rclpy.create_node('broadcaster')
    moving, fixed = TransformBroadcaster(node), StaticTransformBroadcaster(node)
    fixed.sendTransform(transform(f'link{DEPTH}', 'camera', xyz=(0, 0, 1)))
    fixed.sendTransform(transform(f'link{DEPTH}', 'laser', xyz=(0, 0, 2)))

    def tick():
        stamp = node.get_clock().now()
        xyz, xyzw = where(stamp.nanoseconds)
        messages = [transform(f'link{i}', f'link{i + 1}', xyz=xyz, xyzw=xyzw) for i in range(DEPTH)]
        for message in messages:
            message.header.stamp = stamp.to_msg()
        moving.sendTransform(messages)

    node.create_timer(0.01, tick)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
