"""How every program here begins, waits and ends."""

import contextlib
from collections.abc import Callable, Iterator
from typing import Any

import rclpy
from rclpy._rclpy_pybind11 import RCLError
from rclpy.client import Client
from rclpy.executors import Executor, ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future


@contextlib.contextmanager
def ros(args: list[str] | None = None) -> Iterator[None]:
    """
    Initialise rclpy for the block; Ctrl+C and SIGTERM leave it, and the program ends without a traceback.

    ROS arguments that cannot be read are an error.
    """
    with contextlib.suppress(KeyboardInterrupt):
        rclpy.init(args=args)
        try:
            yield
        except ExternalShutdownException:
            pass
        except RCLError:
            # A signal takes the context away at once; a callback that is about to publish then fails.
            if rclpy.ok():
                raise
        finally:
            with contextlib.suppress(RCLError):  # the signal's handler may shut down at the same moment
                rclpy.try_shutdown()


def run(make_node: Callable[[], Node], args: list[str] | None = None) -> None:
    """Make a node and spin it until a signal comes."""
    with ros(args):
        executor = SingleThreadedExecutor()  # before the node speaks: a signal in between would break it
        rclpy.spin(make_node(), executor)


def wait_for(client: Client, tell: Callable[[str], object]) -> None:
    """Wait for a service, and say so each second."""
    while not client.wait_for_service(timeout_sec=1.0):
        if not client.context.ok():
            raise ExternalShutdownException
        tell('service not available, waiting again...')


def result_of(future: Future, executor: Executor) -> Any:
    """Spin until the future is done, and return its result; ExternalShutdownException if a signal comes before."""
    executor.spin_until_future_complete(future)
    if not future.done():
        raise ExternalShutdownException
    return future.result()
