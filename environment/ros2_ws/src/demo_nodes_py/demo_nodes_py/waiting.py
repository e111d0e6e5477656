"""How a program waits for a service and for an answer."""

from collections.abc import Callable
from typing import Any

from rclpy.client import Client
from rclpy.executors import Executor, ExternalShutdownException
from rclpy.task import Future


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
