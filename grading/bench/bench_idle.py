"""Doing nothing: processor time of a process with five nodes that spin in the background, beside plain rclpy."""

import statistics
import subprocess
import sys
from collections.abc import Iterator

from grading.bench import Measurement

NODES = 5
SECONDS = 5.0
ROUNDS = 3
_WITH_HELPERS = """
import helpers
helpers.ros.start()
spinning = helpers.spinning(*map(rclpy.create_node, names))
"""
_WITH_RCLPY = """
rclpy.init()
nodes = [rclpy.create_node(name) for name in names]
import threading
from rclpy.executors import SingleThreadedExecutor
executor = SingleThreadedExecutor()
for node in nodes:
    executor.add_node(node)
threading.Thread(target=executor.spin, daemon=True).start()
"""
_BEGIN = f"""
import os, sys, time
import rclpy
names = [f'idle_{{number}}' for number in range({NODES})]
"""
# After a second the nodes have found each other.
_WATCH = """
time.sleep(1.0)
wall, spent = time.monotonic(), time.process_time()
time.sleep(float(sys.argv[1]))
print((time.process_time() - spent) / (time.monotonic() - wall), flush=True)
os._exit(0)
"""


def measure() -> Iterator[Measurement]:
    """Yield the medians of several processes of each kind, taken in turn."""
    cores: dict[str, list[float]] = {_WITH_HELPERS: [], _WITH_RCLPY: []}
    for number in range(ROUNDS):
        for code, found in cores.items() if number % 2 else reversed(cores.items()):
            done = subprocess.run(
                [sys.executable, '-c', _BEGIN + code + _WATCH, str(SECONDS)],
                check=True,
                text=True,
                stdout=subprocess.PIPE,
                timeout=60,
            )
            found.append(float(done.stdout.split()[-1]))
    ours, theirs = (1e3 * statistics.median(found) for found in cores.values())
    yield Measurement(f'{NODES} idle nodes', ours, '1/1000 core', 'plain rclpy', theirs)
