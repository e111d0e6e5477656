"""TfView: updates a second that reach a browser, and the processor time of the kernel; the simulated robot's figures.

The frames move at 30 Hz, sent by another process as one message; a third one receives what a browser would. `cores` is
the processor time of the kernel's process alone, per second: listening, buffer, poses, web server.
"""

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator

import psutil

from grading.bench import physics
from helpers import paths
from helpers.kernel import domains

COUNTS = (10, 50, 100)
SECONDS = 5.0
_BROADCASTER = """
import math, sys
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.executors import ExternalShutdownException
from tf2_ros import TransformBroadcaster

count, together = int(sys.argv[1]), sys.argv[2] == 'together'
rclpy.init()
node = rclpy.create_node('broadcaster')
broadcaster = TransformBroadcaster(node)


def send():
    now = node.get_clock().now()
    transforms = []
    for number in range(count):
        message = TransformStamped()
        message.header.stamp = now.to_msg()
        # chains of ten frames that all begin at the root
        message.header.frame_id = 'root' if number % 10 == 0 else f'frame_{number - 1}'
        message.child_frame_id = f'frame_{number}'
        message.transform.translation.x = 0.3
        message.transform.translation.y = 0.1 * (number // 10)
        angle = 0.5 * math.sin(now.nanoseconds / 1e9 + number)
        message.transform.rotation.z, message.transform.rotation.w = math.sin(angle / 2), math.cos(angle / 2)
        transforms.append(message)
    for part in [transforms] if together else transforms:
        broadcaster.sendTransform(part)


node.create_timer(1 / 30, send)
print('ready', flush=True)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""
_SENSORS = """
import math, sys
import numpy as np
import rclpy
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from rclpy.executors import ExternalShutdownException
from sensor_msgs.msg import LaserScan, PointCloud2
from sensor_msgs_py.point_cloud2 import create_cloud_xyz32
from std_msgs.msg import Header
from tf2_ros import TransformBroadcaster

rclpy.init()
node = rclpy.create_node('robot')
broadcaster = TransformBroadcaster(node)
scans = node.create_publisher(LaserScan, '/scan', 5)
clouds = node.create_publisher(PointCloud2, '/points', 5)
odometry = node.create_publisher(Odometry, '/odom', 10)
points = np.random.default_rng(0).uniform(-1, 1, (20_000, 3)).astype(np.float32)
ranges = [3.0 + math.sin(0.1 * beam) for beam in range(360)]


def move():
    now = node.get_clock().now()
    angle = now.nanoseconds / 1e9 % 1000
    header = Header(stamp=now.to_msg(), frame_id='odom')
    message = TransformStamped(header=header, child_frame_id='base')
    message.transform.translation.x, message.transform.translation.y = math.cos(angle), math.sin(angle)
    message.transform.rotation.w = 1.0
    broadcaster.sendTransform(message)
    place = Odometry(header=header, child_frame_id='base')
    place.pose.pose.position.x, place.pose.pose.position.y = math.cos(angle), math.sin(angle)
    odometry.publish(place)


def header():
    return Header(stamp=node.get_clock().now().to_msg(), frame_id='base')


def scan():
    scans.publish(LaserScan(header=header(), angle_increment=math.tau / 360, range_max=10.0, ranges=ranges))


node.create_timer(1 / 50, move)
if 'scan' in sys.argv:
    node.create_timer(1 / 10, scan)
if 'cloud' in sys.argv:
    node.create_timer(1 / 5, lambda: clouds.publish(create_cloud_xyz32(header(), points)))
print('ready', flush=True)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
except Exception:
    if rclpy.ok():  # else it was told to end while it was sending
        raise
"""
_BROWSER = """
import asyncio, json, sys, time
from tornado.websocket import websocket_connect


async def main():
    socket = await websocket_connect(sys.argv[1], max_message_size=2**26)
    seconds = float(sys.argv[2])
    drawn = json.dumps({'drawn': 1})  # a browser says so, else it gets no more
    await socket.read_message()
    await socket.write_message(drawn)
    print('ready', flush=True)
    sys.stdin.readline()
    begin, count, size = time.monotonic(), 0, 0
    while time.monotonic() - begin < seconds:
        message = await socket.read_message()
        await socket.write_message(drawn)
        count, size = count + 1, size + len(message)
    elapsed = time.monotonic() - begin
    print(json.dumps({'rate': count / elapsed, 'size': size / max(1, count)}), flush=True)


asyncio.run(main())
"""


def measure() -> Iterator[tuple[str, float, str]]:
    """Yield rate, processor time and size of messages for each tree, and the figures of the physics.

    :raises RuntimeError: a tree does not come.
    """
    for count in COUNTS:
        yield from tree(count)
    yield from tree(COUNTS[-1], together=False)
    yield from sensors()
    yield from physics.measure()


def tree(count: int, together: bool = True) -> Iterator[tuple[str, float, str]]:
    """Yield the rows of one tree of frames.

    :param together: all transforms of a moment in one message, as of a robot_state_publisher; else one message each.
    """
    how = 'together' if together else 'each in a message of its own'
    with domains.claim() as domain_id, _Child(_BROADCASTER, str(count), how, ROS_DOMAIN_ID=str(domain_id)) as sender:
        sender.line()
        name = f'{count} frames' if together else f'{count} frames, {how}'
        yield from view(name, domain_id, lambda view: len(view.frames) > count)


def sensors() -> Iterator[tuple[str, float, str]]:
    """Yield the rows of a robot's sensors: odometry at 50 Hz, 360 beams at 10 Hz, 20,000 points at 5 Hz."""
    from helpers.show.views import LaserScan, Odometry, PointCloud2

    for name, sends, displays in (
        ('odometry', (), [Odometry]),
        ('odometry, scan', ('scan',), [Odometry, LaserScan]),
        ('odometry, scan, cloud', ('scan', 'cloud'), [Odometry, LaserScan, PointCloud2]),
    ):
        with domains.claim() as domain_id, _Child(_SENSORS, *sends, ROS_DOMAIN_ID=str(domain_id)) as sender:
            sender.line()
            yield from view(
                name,
                domain_id,
                lambda view: not view.problems and len(view.frames) == 2,
                *(display() for display in displays),
            )


def view(name: str, domain_id: int, is_there: Callable, *displays) -> Iterator[tuple[str, float, str]]:
    """Yield the rows of a view of what happens in a domain.

    :param is_there: takes the view; True as soon as all that is to be measured is shown.
    :param displays: for the view.
    """
    from helpers import ros, wait_for
    from helpers.show.views import TfView

    ros.start(domain_id)
    try:
        with TfView(*displays, live=True) as shown:
            wait_for(lambda: is_there(shown), timeout=30)
            with _Child(_BROWSER, shown.address.replace('http', 'ws') + 'socket', str(SECONDS)) as browser:
                browser.line()
                me = psutil.Process()
                before, begin = sum(me.cpu_times()[:2]), time.monotonic()
                browser.say('begin')
                result = json.loads(browser.line())
                cores = (sum(me.cpu_times()[:2]) - before) / (time.monotonic() - begin)
    finally:
        ros.stop()
    yield f'{name}: updates', result['rate'], '1/s'
    yield f'{name}: processor', cores, 'cores'
    yield f'{name}: message', result['size'] / 1024, 'KiB'


class _Child:
    """A Python program as a child process."""

    def __init__(self, code: str, *arguments: str, **environment: str):
        import os

        self._popen = subprocess.Popen(
            [sys.executable, '-c', code, *arguments],
            cwd=paths.ROOT,
            text=True,
            bufsize=1,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**os.environ, **environment},
        )

    def line(self) -> str:
        """Wait for a line of its output."""
        text = self._popen.stdout.readline()
        if not text:
            raise RuntimeError(f'a part of the benchmark ended with {self._popen.wait()}')
        return text

    def say(self, text: str) -> None:
        """Send it a line."""
        self._popen.stdin.write(text + '\n')

    def __enter__(self) -> '_Child':
        return self

    def __exit__(self, *_) -> None:
        self._popen.terminate()
        self._popen.wait(10)
