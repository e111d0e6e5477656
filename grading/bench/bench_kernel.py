"""A notebook's kernel: from its start to the first message between two nodes, beside a plain rclpy program."""

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from grading.bench import Measurement
from helpers.tests.real_kernel import Kernel

STARTS = 5
_PEER = 'plain rclpy program'
_NODES = """
import rclpy
from std_msgs.msg import String

{start}
alice, bob = rclpy.create_node('alice'), rclpy.create_node('bob')
heard = []
bob.create_subscription(String, 'chatter', heard.append, 10)
publisher = alice.create_publisher(String, 'chatter', 10)
"""
IN_A_NOTEBOOK = (
    _NODES.format(start='import helpers\nfrom helpers import spinning, wait_for\nhelpers.ros.start()')
    + """
with spinning(alice, bob):
    wait_for(lambda: publisher.get_subscription_count())
    publisher.publish(String(data='hello'))
    wait_for(lambda: heard)
"""
)
PLAIN = (
    _NODES.format(start='from rclpy.executors import SingleThreadedExecutor\nrclpy.init()')
    + """
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
)


def measure() -> Iterator[Measurement]:
    """Yield the medians of several fresh kernels and programs, taken in turn.

    To make a kernel ready is Jupyter's part, which a program does not have; the cell then does what the program does.

    :raises RuntimeError: the message did not come.
    """
    ready, whole, plain = [], [], []
    _program()  # does not count: it reads from the disk what the others then find in memory
    for _ in range(STARTS):
        kernel = _kernel()
        ready.append(kernel[0])
        whole.append(kernel[1])
        plain.append(_program())
    cell = [end - begin for begin, end in zip(ready, whole, strict=True)]
    program = statistics.median(plain)
    yield Measurement('kernel ready', statistics.median(ready), 's')
    yield Measurement('ready kernel to first message', statistics.median(cell), 's', _PEER, program)
    yield Measurement('start to first message', statistics.median(whole), 's', _PEER, program)
    yield Measurement('start to first message, worst', max(whole), 's', _PEER, max(plain))


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
        # Not just the first line: Fast DDS may have a remark.
        heard = any(line == 'heard\n' for line in program.stdout)
        seconds = time.perf_counter() - begin
    if not heard:
        raise RuntimeError(f'the plain program ended with {program.returncode}')
    return seconds
