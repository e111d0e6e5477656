"""
Filters for streams of messages: a subscription, a cache, a chain, and synchronisers by time stamp.

A filter hands what it lets through to the callbacks that were registered with it. The names are upstream's.
"""

import itertools
import threading
from collections.abc import Callable, Iterable
from typing import Any

from rclpy.clock import ROSClock
from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.time import Time

__all__ = ['ApproximateTimeSynchronizer', 'Cache', 'Chain', 'SimpleFilter', 'Subscriber', 'TimeSynchronizer']


class SimpleFilter:
    """What all filters have: callbacks that get the output."""

    def __init__(self) -> None:
        """Begin without a callback."""
        self.callbacks: dict[int, tuple[Callable, tuple]] = {}
        self._next_connection = 0

    def registerCallback(self, cb: Callable, *args: Any) -> int:
        """Call `cb` with each output, followed by `args`; returns the key of the callback in `callbacks`."""
        connection = self._next_connection
        self._next_connection += 1
        self.callbacks[connection] = (cb, args)
        return connection

    def signalMessage(self, *msg: Any) -> None:
        """Hand an output to the callbacks, in the order in which they were registered."""
        for callback, args in list(self.callbacks.values()):
            callback(*msg, *args)


class Subscriber(SimpleFilter):
    """
    A subscription as the first filter: `Subscriber(node, message type, topic, …)`.

    Further arguments are those of `create_subscription`; the quality of service is a queue of 10 if none is given.
    What the subscription has, this object has, too.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Subscribe."""
        super().__init__()
        self.node, message_type, self.topic, *others = args
        if not others:
            kwargs.setdefault('qos_profile', 10)
        self.sub = self.node.create_subscription(message_type, self.topic, self.callback, *others, **kwargs)

    def callback(self, msg: Any) -> None:
        """Hand a message on."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """Return the name of the topic, as it was given."""
        return self.topic

    def __getattr__(self, key: str) -> Any:
        """Return an attribute of the subscription."""
        if key == 'sub':  # not subscribed: do not look for it in itself
            raise AttributeError(key)
        return getattr(self.sub, key)


def _stamp_of(msg: Any, allow_headerless: bool, logger: str) -> Time | None:
    """Return a message's stamp; without one the time now, or None after a warning if that is not allowed."""
    stamp = getattr(getattr(msg, 'header', None), 'stamp', None)
    if stamp is not None:
        return stamp if isinstance(stamp, Time) else Time.from_msg(stamp)
    if allow_headerless:
        return ROSClock().now()
    get_logger(logger).warning(
        f'{type(msg).__name__} has no header with a stamp, so the message is left out. '
        "With the option 'allow_headerless' it gets the time at which it arrived."
    )
    return None


class Cache(SimpleFilter):
    """
    Keeps the latest messages, and hands each on.

    With `allow_headerless` a message without a header counts as one of the time at which it arrived.
    """

    def __init__(self, f: SimpleFilter, cache_size: int = 1, allow_headerless: bool = False) -> None:
        """Keep so many messages of the filter `f`."""
        super().__init__()
        self.cache_size = cache_size
        self.allow_headerless = allow_headerless
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        self.connectInput(f)

    def connectInput(self, f: SimpleFilter) -> None:
        """Take the messages of a filter."""
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Keep a message; the one that came first leaves if there are too many."""
        stamp = _stamp_of(msg, self.allow_headerless, 'message_filters_cache')
        if stamp is None:
            return
        self.cache_msgs.append(msg)
        self.cache_times.append(stamp)
        if len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def _chosen(self, condition: Callable[[Time], bool]) -> list[Any]:
        return [msg for msg, time in zip(self.cache_msgs, self.cache_times, strict=True) if condition(time)]

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Any]:
        """Return the messages between two times, both included; AssertionError if the first is the later one."""
        assert from_stamp <= to_stamp, 'the interval ends before it begins'
        return self._chosen(lambda time: from_stamp <= time <= to_stamp)

    def getElemAfterTime(self, stamp: Time) -> Any:
        """Return the first message at or after a time, or None."""
        return next(iter(self._chosen(lambda time: time >= stamp)), None)

    def getElemBeforeTime(self, stamp: Time) -> Any:
        """Return the last message at or before a time, or None."""
        return next(reversed(self._chosen(lambda time: time <= stamp)), None)

    def getLastestTime(self) -> Time | None:  # so spelled upstream
        """Return the stamp of the last message, or None."""
        return self.cache_times[-1] if self.cache_times else None

    getLatestTime = getLastestTime

    def getOldestTime(self) -> Time | None:
        """Return the stamp of the first message that is kept, or None."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """Return the message with the latest stamp, or None."""
        latest = self.getLastestTime()
        return None if latest is None else self.getElemAfterTime(latest)


class Chain(SimpleFilter):
    """Several filters, one after the other, as one."""

    def __init__(self, message_filter: SimpleFilter | None = None) -> None:
        """Take the messages of a filter, if one is given."""
        super().__init__()
        self.incoming_connection: int | None = None
        self._filters: list[SimpleFilter] = []
        self._output: int | None = None  # how the last filter is connected to the chain's callbacks
        if message_filter is not None:
            self.connectInput(message_filter)

    def connectInput(self, message_filter: SimpleFilter) -> None:
        """Take the messages of a filter; RuntimeError if the chain has an input already."""
        if self.incoming_connection is not None:
            raise RuntimeError('Already connected')
        self.incoming_connection = message_filter.registerCallback(self.add)

    def add(self, message: Any) -> None:
        """Put a message in."""
        if self._filters:
            self._filters[0].add(message)
        else:
            self.signalMessage(message)

    def addFilter(self, message_filter: SimpleFilter) -> None:
        """Put a filter at the end."""
        if self._filters:
            last = self._filters[-1]
            del last.callbacks[self._output]
            last.registerCallback(message_filter.add)
        self._filters.append(message_filter)
        self._output = message_filter.registerCallback(self.signalMessage)

    def getFilter(self, index: int) -> SimpleFilter:
        """Return the filter at a place; KeyError if there is none."""
        return dict(enumerate(self._filters))[index]


class TimeSynchronizer(SimpleFilter):
    """
    Hands on messages of several filters together when they have the same stamp.

    The callback gets one message of each filter, in the order of the filters. What is older than the set that was
    handed on last, and still waits for others, is forgotten, as in C++.
    """

    def __init__(self, fs: Iterable[SimpleFilter], queue_size: int) -> None:
        """Take the messages of the filters; keep so many of each while others are awaited."""
        super().__init__()
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self.connectInput(fs)

    def connectInput(self, fs: Iterable[SimpleFilter]) -> None:
        """Take the messages of these filters."""
        fs = list(fs)
        self.queues: list[dict[int, Any]] = [{} for _ in fs]  # of each filter the messages by their stamp
        self.input_connections = [f.registerCallback(self.add, self.queues[index], index) for index, f in enumerate(fs)]

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        """Take a message for a queue, and hand on the sets that are complete."""
        with self.lock:
            self._keep(my_queue, Time.from_msg(msg.header.stamp).nanoseconds, msg)
            for stamp in sorted(set.intersection(*(set(queue) for queue in self.queues))):
                for queue in self.queues:
                    for older in [each for each in queue if each < stamp]:
                        del queue[older]
                self._hand_on([stamp] * len(self.queues))

    def _keep(self, queue: dict[int, Any], stamp: int, msg: Any) -> None:
        queue[stamp] = msg
        while len(queue) > self.queue_size:
            del queue[min(queue)]

    def _hand_on(self, stamps: list[int]) -> None:
        """Hand on, and forget, the message with the given stamp of each queue."""
        self.signalMessage(*(queue.pop(stamp) for queue, stamp in zip(self.queues, stamps, strict=True)))


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """
    Hands on messages of several filters together when their stamps differ by less than `slop` seconds.

    With `allow_headerless` a message without a header counts as one of the time at which it arrived.
    """

    def __init__(
        self, fs: Iterable[SimpleFilter], queue_size: int, slop: float, allow_headerless: bool = False
    ) -> None:
        """Take the messages of the filters."""
        super().__init__(fs, queue_size)
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        """Take a message for a queue; hand it on with the nearest ones of the other queues, if they are near enough."""
        time = _stamp_of(msg, self.allow_headerless, 'message_filters_approx')
        if time is None:
            return
        stamp, slop = time.nanoseconds, self.slop.nanoseconds
        with self.lock:
            self._keep(my_queue, stamp, msg)
            candidates = []
            for index, queue in enumerate(self.queues):
                if index == my_queue_index:
                    candidates.append([stamp])
                else:
                    near = [each for each in queue if abs(each - stamp) <= slop]
                    candidates.append(sorted(near, key=lambda each: abs(each - stamp)))
            # The nearest of each queue come first.
            for stamps in itertools.product(*candidates):
                there = all(each in queue for each, queue in zip(stamps, self.queues, strict=True))
                if there and max(stamps) - min(stamps) < slop:
                    self._hand_on(list(stamps))
                    return
