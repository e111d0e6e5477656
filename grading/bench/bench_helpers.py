"""Background spinning: latency and rate of messages between two nodes of a process, beside plain rclpy, in one run."""

import statistics
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from grading.bench import Figure

ROUNDS = 15  # of each, in turn: what disturbs one disturbs the other; rates of short rounds differ by half
SECONDS = 0.4
PATIENCE = 10.0
_IN_FLIGHT = 8  # messages, for the rate; fewer than the queue is deep, so that none is lost
_PEER = 'plain rclpy'


def measure() -> Iterator[Figure]:
    """Yield latency and rate with `helpers.spinning`, beside an executor in a thread.

    :raises RuntimeError: a message did not come.
    """
    from helpers import ros

    ways = (_with_helpers, _with_rclpy)
    latencies, rates = {way: [] for way in ways}, {way: [] for way in ways}
    ros.start()
    try:
        for number in range(ROUNDS):
            for way in ways if number % 2 else reversed(ways):
                latencies[way] += _round(way, 1)
                rates[way].append(len(_round(way, _IN_FLIGHT)) / SECONDS)
    finally:
        ros.stop()
    ours, theirs = ([1e6 * seconds for seconds in latencies[way]] for way in ways)
    yield Figure('latency, median', statistics.median(ours), 'us', _PEER, statistics.median(theirs))
    yield Figure('latency, 99 %', _worst(ours), 'us', _PEER, _worst(theirs))
    yield Figure(
        'messages, median', statistics.median(rates[_with_helpers]), '1/s', _PEER, statistics.median(rates[_with_rclpy])
    )


def _worst(values: list[float]) -> float:
    return statistics.quantiles(values, n=100)[-1]


def _round(spin: Callable, in_flight: int) -> list[float]:
    """The seconds that each message needed that came within SECONDS, with so many on their way at a time."""
    import rclpy
    from std_msgs.msg import Int64

    needed, over, here = [], threading.Event(), threading.Event()
    alice, bob = rclpy.create_node('alice'), rclpy.create_node('bob')
    ball = alice.create_publisher(Int64, 'ball', 10)
    thanks = bob.create_publisher(Int64, 'thanks', 10)

    def throw(_=None) -> None:
        if not over.is_set():
            ball.publish(Int64(data=time.perf_counter_ns()))

    def catch(message) -> None:
        needed.append((time.perf_counter_ns() - message.data) / 1e9)
        here.set()
        thanks.publish(message)

    bob.create_subscription(Int64, 'ball', catch, 10)
    alice.create_subscription(Int64, 'thanks', throw, 10)
    with spin(alice, bob):
        end = time.monotonic() + PATIENCE
        while not (ball.get_subscription_count() and thanks.get_subscription_count()):
            if time.monotonic() > end:
                raise RuntimeError('the nodes did not find each other')
            time.sleep(0.01)
        for _ in range(in_flight):
            throw()
        if not here.wait(PATIENCE):
            raise RuntimeError('no message came')
        needed.clear()
        time.sleep(SECONDS)
        count = len(needed)
        over.set()
    return needed[:count]


def _with_helpers(*nodes):
    from helpers import spinning

    return spinning(*nodes)


@contextmanager
def _with_rclpy(*nodes) -> Iterator[None]:
    from rclpy.executors import SingleThreadedExecutor

    executor = SingleThreadedExecutor()
    for node in nodes:
        executor.add_node(node)
    over = threading.Event()

    def spin() -> None:
        while not over.is_set():
            executor.spin_once(timeout_sec=0.1)

    thread = threading.Thread(target=spin)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join(PATIENCE)
        executor.shutdown()
        for node in nodes:
            node.destroy_node()
