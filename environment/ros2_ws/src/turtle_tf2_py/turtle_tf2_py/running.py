"""How every program here begins and ends."""

import contextlib
from collections.abc import Callable

import rclpy
from rclpy._rclpy_pybind11 import RCLError
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node


def run(make_node: Callable[[], Node]) -> None:
    """Make a node and spin it until Ctrl+C or SIGTERM comes; ROS arguments that cannot be read are an error."""
    with contextlib.suppress(KeyboardInterrupt):
        rclpy.init()
        try:
            executor = SingleThreadedExecutor()  # before the node speaks: a signal in between would break it
            rclpy.spin(make_node(), executor)
        except ExternalShutdownException:
            pass
        except Exception:
            # A signal takes the context away at once; a callback that is about to publish then fails.
            if rclpy.ok():
                raise
        finally:
            with contextlib.suppress(RCLError):  # the signal's handler may shut down at the same moment
                rclpy.try_shutdown()
