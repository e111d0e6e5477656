"""Background spinning: latency and rate of messages between two nodes of a process, beside plain rclpy, in one run."""

import statistics
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from grading.bench import Measurement

ROUNDS = 15  # of each, in turn: what disturbs one disturbs the other
SECONDS = 0.4
PATIENCE = 10.0
_BURST = 8  # messages, for the rate; fewer than the queue is deep, so that none is lost
_PEER = 'plain rclpy'


def measure() -> Iterator[Measurement]:
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
                latencies[way] += _latencies(way)
                rates[way].append(_rate(way))
    finally:
        ros.stop()
    ours, theirs = ([1e6 * seconds for seconds in latencies[way]] for way in ways)
    yield Measurement('latency, median', statistics.median(ours), 'us', _PEER, statistics.median(theirs))
    yield Measurement('latency, 99 %', _worst(ours), 'us', _PEER, _worst(theirs))
    yield Measurement(
        'messages, median', statistics.median(rates[_with_helpers]), '1/s', _PEER, statistics.median(rates[_with_rclpy])
    )


def _worst(values: list[float]) -> float:
    return statistics.quantiles(values, n=100)[-1]


def _latencies(spin: Callable) -> list[float]:
    """The seconds that each message needed, one at a time, back and forth for SECONDS."""
    import rclpy
    from std_msgs.msg import Int64

    needed, over = [], threading.Event()
    alice, bob = rclpy.create_node('alice'), rclpy.create_node('bob')
    ball = alice.create_publisher(Int64, 'ball', 10)
    thanks = bob.create_publisher(Int64, 'thanks', 10)

    def throw(_=None) -> None:
        if not over.is_set():
            ball.publish(Int64(data=time.perf_counter_ns()))

    def catch(message) -> None:
        needed.append((time.perf_counter_ns() - message.data) / 1e9)
        thanks.publish(message)

    bob.create_subscription(Int64, 'ball', catch, 10)
    alice.create_subscription(Int64, 'thanks', throw, 10)
    with spin(alice, bob):
        _until(
            lambda: ball.get_subscription_count() and thanks.get_subscription_count(), 'the nodes to find each other'
        )
        throw()
        _until(lambda: needed, 'the first message')
        needed.clear()
        time.sleep(SECONDS)
        count = len(needed)
        over.set()
    return needed[:count]


def _rate(spin: Callable) -> float:
    """Messages in a second, published in bursts from outside of the callbacks: nothing but the spinning bounds it.

    Messages that answer each other, several at a time, would give rates between 11,000 and 36,000 for the same code:
    how many of them an executor finds in one wait then depends on how they happened to begin.
    """
    import rclpy
    from std_msgs.msg import Int64

    here = threading.Event()
    alice, bob = rclpy.create_node('alice'), rclpy.create_node('bob')
    ball = alice.create_publisher(Int64, 'ball', 10)

    def catch(message) -> None:
        if message.data == _BURST - 1:
            here.set()

    bob.create_subscription(Int64, 'ball', catch, 10)
    bursts = 0
    with spin(alice, bob):
        _until(ball.get_subscription_count, 'the nodes to find each other')
        begin = time.perf_counter()
        while time.perf_counter() - begin < SECONDS:
            here.clear()
            for number in range(_BURST):
                ball.publish(Int64(data=number))
            if not here.wait(PATIENCE):
                raise RuntimeError(f'the last message of a burst of {_BURST} did not come')
            bursts += 1
        seconds = time.perf_counter() - begin
    return bursts * _BURST / seconds


def _until(condition: Callable, what: str) -> None:
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise RuntimeError(f'waited {PATIENCE:g} s in vain for {what}')
        time.sleep(0.01)


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
