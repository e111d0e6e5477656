"""How every node here begins and ends."""

from collections.abc import Callable

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def run(make_node: Callable[[], Node], args: list[str] | None) -> None:
    """Make a node and spin it until Ctrl+C, SIGTERM or a shutdown of its context."""
    try:
        rclpy.init(args=args)
        rclpy.spin(make_node())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
