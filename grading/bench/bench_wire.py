"""Two nodes in two processes: time to the first message, and the latency of one message."""

import os
import statistics
import subprocess
import sys
import time
from collections.abc import Iterator

from helpers.kernel import domains

STARTS = 8
MESSAGES = 500
ECHO = """
import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Int64
rclpy.init()
node = rclpy.create_node('echo')
publisher = node.create_publisher(Int64, 'reply', 10)
node.create_subscription(Int64, 'request', publisher.publish, 10)
print('ready', flush=True)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield the median and the worst of several fresh pairs, and of round trips halved."""
    first, latency = [], []
    for _ in range(STARTS):
        with domains.claim() as domain_id:
            first.append(_pair(domain_id, latency))
    yield 'first message, median', 1e3 * statistics.median(first), 'ms'
    yield 'first message, worst', 1e3 * max(first), 'ms'
    yield 'latency, median', 1e3 * statistics.median(latency), 'ms'
    yield 'latency, 99 %', 1e3 * statistics.quantiles(latency, n=100)[-1], 'ms'


def _pair(domain_id: int, latency: list[float]) -> float:
    """Return the seconds from the creation of a node to its first reply; add to ``latency``, in seconds."""
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from std_msgs.msg import Int64

    environment = {**os.environ, 'ROS_DOMAIN_ID': str(domain_id)}
    with subprocess.Popen([sys.executable, '-c', ECHO], env=environment, stdout=subprocess.PIPE, text=True) as echo:
        context = rclpy.Context()
        try:
            if not any(line == 'ready\n' for line in echo.stdout):  # Fast DDS may have a remark before
                raise RuntimeError('the echo node did not start')
            rclpy.init(context=context, domain_id=domain_id)
            begin = time.perf_counter()
            node = rclpy.create_node('asker', context=context)
            executor = SingleThreadedExecutor(context=context)
            executor.add_node(node)
            replies = []
            node.create_subscription(Int64, 'reply', lambda message: replies.append(message.data), 10)
            publisher = node.create_publisher(Int64, 'request', 10)
            _ask(executor, publisher, replies, 0, resend=0.01)
            first = time.perf_counter() - begin
            for number in range(1, MESSAGES // STARTS + 1):
                sent = time.perf_counter()
                _ask(executor, publisher, replies, number)
                latency.append((time.perf_counter() - sent) / 2)
            executor.shutdown()
            node.destroy_node()
        finally:
            rclpy.try_shutdown(context=context)
            echo.kill()  # a signal that comes just before rclpy waits can be lost
    return first


def _ask(executor, publisher, replies, number, resend=10.0, patience=10.0) -> None:
    """Publish until the reply to ``number`` is there. Messages are lost until both sides match, hence ``resend``."""
    from std_msgs.msg import Int64

    end = time.monotonic() + patience
    while number not in replies:
        if time.monotonic() > end:
            raise TimeoutError(f'no reply within {patience} s')
        publisher.publish(Int64(data=number))
        again = time.monotonic() + resend
        while number not in replies and time.monotonic() < again:
            executor.spin_once(timeout_sec=resend)
