"""How every program here begins and ends."""

import contextlib
from collections.abc import Callable

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def run(make_node: Callable[[], Node]) -> None:
    """Make a node and spin it until Ctrl+C or SIGTERM comes."""
    rclpy.init()
    try:
        with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
            rclpy.spin(make_node())
    except Exception:
        # A signal takes the context away at once; a callback that is about to publish then fails.
        if rclpy.ok():
            raise
    finally:
        rclpy.try_shutdown()
