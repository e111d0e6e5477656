"""The simulated robot: how fast its physics and its sensors are, and what its node costs. Rows of ``bench views``."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator

from helpers.kernel import domains

SECONDS = 5.0
BUDGET = 1.0  # seconds of processor time for each figure
_NODE = """
import json, sys, time
import rclpy
from mujoco_world.node import WorldNode
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter

rclpy.init()
node = WorldNode(parameter_overrides=[Parameter('real_time_factor', value=float(sys.argv[1]))])
node.world.drive(0.3, 0.5)
node.world.keep_command()
executor = SingleThreadedExecutor()
executor.add_node(node)


def spin(seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)


spin(1.0)
wall, cpu, simulated = time.monotonic(), time.process_time(), node.world.time
spin(float(sys.argv[2]))
wall = time.monotonic() - wall
print(json.dumps({'factor': (node.world.time - simulated) / wall, 'cores': (time.process_time() - cpu) / wall}))
executor.shutdown()
node.destroy_node()
rclpy.shutdown()
"""


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield what there is to say of the physics world: (what, value, unit)."""
    from mujoco_world.model import TIMESTEP
    from mujoco_world.world import NoPicturesError, World

    world = World()
    world.drive(0.3, 0.5)
    steps = 0.1 / TIMESTEP  # in a tenth of a second
    yield 'world: physics steps', steps * _per_second(lambda: world.run(0.1)), '1/s'
    yield 'world: laser scans of 360 rays', _per_second(world.scan), '1/s'
    try:
        world.image()
        yield 'world: camera pictures of 160x120', _per_second(world.image, time.perf_counter), '1/s'
    except NoPicturesError:
        pass  # this machine cannot; there is no number to tell
    world.close()
    for factor, words in ((1.0, 'in real time'), (0.0, 'as fast as possible')):
        figures = _node(factor)
        yield f'world: node {words}, real-time factor', figures['factor'], ''
        yield f'world: node {words}, processor', figures['cores'], 'cores'


def _per_second(call, clock=time.process_time) -> float:
    """How often something can be done; by the processor's time, so that other programs disturb little."""
    call()
    count, begin = 0, clock()
    while (spent := clock() - begin) < BUDGET:
        call()
        count += 1
    return count / spent


def _node(factor: float) -> dict:
    with domains.claim() as domain_id:
        argv = [sys.executable, '-c', _NODE, str(factor), str(SECONDS)]
        done = subprocess.run(
            argv,
            check=True,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=60,
            env={**os.environ, 'ROS_DOMAIN_ID': str(domain_id)},
        )
    return json.loads(done.stdout.splitlines()[-1])
