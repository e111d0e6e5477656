"""A notebook's kernel: from its start to the first message between two nodes, beside a plain rclpy program."""

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from grading.bench import against
from helpers.tests.kernels import Kernel

STARTS = 5
_NODES = """
import rclpy
from std_msgs.msg import String

{start}
alice, bob = rclpy.create_node('alice'), rclpy.create_node('bob')
heard = []
bob.create_subscription(String, 'chatter', heard.append, 10)
publisher = alice.create_publisher(String, 'chatter', 10)
"""
IN_A_NOTEBOOK = _NODES.format(start='import helpers\nfrom helpers import spinning, wait_for\nhelpers.ros.start()') + """
with spinning(alice, bob):
    wait_for(lambda: publisher.get_subscription_count())
    publisher.publish(String(data='hello'))
    wait_for(lambda: heard)
"""
PLAIN = _NODES.format(start='from rclpy.executors import SingleThreadedExecutor\nrclpy.init()') + """
executor = SingleThreadedExecutor()
executor.add_node(alice)
executor.add_node(bob)
while not publisher.get_subscription_count():
    executor.spin_once(timeout_sec=0.01)
publisher.publish(String(data='hello'))
while not heard:
    executor.spin_once(timeout_sec=0.01)
print('heard', flush=True)
"""


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield the medians of several fresh kernels and programs, taken in turn.

    :raises RuntimeError: the message did not come.
    """
    ready, whole, plain = [], [], []
    for _ in range(STARTS):
        kernel = _kernel()
        ready.append(kernel[0])
        whole.append(kernel[1])
        plain.append(_program())
    yield 'kernel ready', statistics.median(ready), 's'
    yield from against('start to first message', statistics.median(whole), 'plain rclpy program',
                       statistics.median(plain), 's')
    yield 'start to first message, worst', max(whole), 's'


def _kernel() -> tuple[float, float]:
    """Seconds until a kernel is ready, and until a message has come in it."""
    with tempfile.TemporaryDirectory(prefix='course-bench-') as folder:
        begin = time.perf_counter()
        with Kernel(Path(folder)) as kernel:
            ready = time.perf_counter() - begin
            result = kernel.run(IN_A_NOTEBOOK)
            whole = time.perf_counter() - begin
    if result.error:
        raise RuntimeError(f'the cell ended with {result.error}: {result.message}')
    return ready, whole


def _program() -> float:
    """Seconds until a message has come in a program that is started for it."""
    begin = time.perf_counter()
    with subprocess.Popen([sys.executable, '-c', PLAIN], stdout=subprocess.PIPE, text=True) as program:
        heard = program.stdout.readline().strip()
        seconds = time.perf_counter() - begin
    if heard != 'heard':
        raise RuntimeError(f'the plain program ended with {program.returncode}')
    return seconds
