"""Callbacks in threads, one at a time, as a MultiThreadedExecutor runs them, but in an order that never changes.

A callback may wait in its thread: on the node's clock, on a rate, on an event or a condition, or in a client's `call`.
It then hands over to the main thread, which gives it its turn again once what it waits for has come. So the main thread
knows when every callback has either returned or waits, which is when simulated time may go on.

Only these waits are known: `Clock.sleep_for` and `sleep_until` on simulated time, everything built on
`threading.Condition` (Event, Semaphore, queue.Queue, rclpy's Rate and `Client.call`), `threading.Lock` in the learner's
own code, and `time.sleep`, which waits on the wall clock. A timeout of a wait is counted in simulated time.
"""
import _thread
import sys
import threading
import time
from collections.abc import Callable

from rclpy.clock import Clock, ClockType

SLEEP_LIMIT = 1.0  # seconds of wall time that callbacks may sleep at one moment of simulated time
SECOND = 1_000_000_000


class Sleeps(Exception):
    """A callback sleeps with `time.sleep`, for longer than SLEEP_LIMIT, while simulated time stands still."""

    def __init__(self, frame):
        super().__init__('time.sleep in a callback')
        self.frame = frame


class _Hand(threading.Thread):
    """A thread of the crew: it works or waits only while the main thread stands still."""

    def __init__(self, crew: 'Crew'):
        super().__init__(daemon=True)
        self.crew = crew
        self.work: tuple | None = None  # (handler, entity, node)
        self.ready: Callable[[], bool] | None = None  # while it waits: whether it may go on
        self.due: int | None = None  # simulated time (ns) at which it goes on by itself
        self.awake_at: float | None = None  # wall time (monotonic) at which its time.sleep ends
        self.turn = _thread.allocate_lock()
        self.turn.acquire()

    def run(self) -> None:
        while True:
            self.turn.acquire()
            handler, *_ = self.work
            try:
                handler()
            except BaseException as error:  # noqa: BLE001 - SystemExit passes through rclpy's own handling
                self.crew.raised[id(handler)] = error
            self.crew.ended.append(self.work)
            self.work = None
            self.crew.idle.append(self)
            self.crew.back.release()

    def wait_for(self, ready: Callable[[], bool], due: int | None = None, awake_at: float | None = None) -> None:
        """Hand over until `ready()`; called in this thread."""
        self.ready, self.due, self.awake_at = ready, due, awake_at
        self.crew.waiting.append(self)
        self.crew.back.release()
        self.turn.acquire()
        self.ready = self.due = self.awake_at = None


class Crew:
    """The threads of a process. `now` gives the simulated time in nanoseconds."""

    def __init__(self, now: Callable[[], int]):
        self.now = now
        self.idle: list[_Hand] = []
        self.waiting: list[_Hand] = []
        self.ended: list[tuple] = []  # work that has ended: (handler, entity, node)
        self.raised: dict[int, BaseException] = {}  # by the id of the handler: what left it
        self.current: _Hand | None = None
        self.back = _thread.allocate_lock()
        self.back.acquire()
        self._slept = (-1, 0.0)  # at which simulated time, for how long
        _patch(self)

    def run(self, handler, entity, node) -> bool:
        """Run a ready callback until it returns (then it is in `ended`) or waits; returns whether it waits."""
        hand = self.idle.pop() if self.idle else self._new_hand()
        hand.work = (handler, entity, node)
        self._give_turn(hand)
        return hand.work is not None

    def resume(self) -> bool:
        """Let every thread go on whose wait is over; returns whether there was one. Sleeps out a `time.sleep`."""
        ready = [hand for hand in self.waiting if hand.ready()]
        if not ready:
            sleepers = [hand for hand in self.waiting if hand.awake_at is not None]
            if sleepers:
                hand = min(sleepers, key=lambda hand: hand.awake_at)
                self._sleep(hand)
                ready = [hand]
        for hand in ready:
            self.waiting.remove(hand)
            self._give_turn(hand)
        return bool(ready)

    def next_due(self) -> int | None:
        """The simulated time (ns) at which the next wait is over by itself."""
        return min((hand.due for hand in self.waiting if hand.due is not None), default=None)

    def here(self) -> '_Hand | None':
        """The thread of this crew in which the caller runs."""
        hand = threading.current_thread()
        return hand if isinstance(hand, _Hand) and hand.crew is self else None

    def frame(self, hand: _Hand | None = None):
        """The innermost frame of a thread; of the one that has its turn, if none is given. None if there is none."""
        hand = hand or self.current
        return sys._current_frames().get(hand.ident) if hand else None

    def _new_hand(self) -> _Hand:
        hand = _Hand(self)
        hand.start()
        return hand

    def _give_turn(self, hand: _Hand) -> None:
        self.current = hand
        hand.turn.release()
        self.back.acquire()
        self.current = None

    def _sleep(self, hand: _Hand) -> None:
        left = max(0.0, hand.awake_at - time.monotonic())
        moment, slept = self._slept
        slept = left + (slept if moment == self.now() else 0.0)
        if slept > SLEEP_LIMIT:
            raise Sleeps(self.frame(hand))
        self._slept = (self.now(), slept)
        _plain_sleep(left)


class _Waiter:
    """What a Condition notifies: the place of the lock on which a plain thread would block."""

    def __init__(self):
        self.notified = False

    def release(self) -> None:
        self.notified = True


class _Lock:
    """A lock on which a thread of the crew may wait while another one holds it."""

    def __init__(self):
        self._slots = threading.Semaphore(1)
        self.acquire = self._slots.acquire

    def release(self) -> None:
        if not self.locked():
            raise RuntimeError('release unlocked lock')
        self._slots.release()

    def locked(self) -> bool:
        return not self._slots._value

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_) -> None:
        self.release()


_plain_sleep = time.sleep


def _patch(crew: Crew) -> None:
    """Make the waits that are known hand over, in threads of the crew; elsewhere they stay what they are."""
    plain_wait, plain_sleep_until, plain_lock = threading.Condition.wait, Clock.sleep_until, threading.Lock

    def wait(self, timeout=None):
        hand = crew.here()
        if hand is None:
            return plain_wait(self, timeout)
        if not self._is_owned():
            raise RuntimeError('cannot wait on un-acquired lock')
        waiter = _Waiter()
        self._waiters.append(waiter)
        saved = self._release_save()
        due = None if timeout is None else crew.now() + max(0, round(timeout * SECOND))
        try:
            hand.wait_for(lambda: waiter.notified or (due is not None and crew.now() >= due), due)
        finally:
            self._acquire_restore(saved)
            if not waiter.notified:
                self._waiters.remove(waiter)
        return waiter.notified

    def sleep_until(self, until, context=None):
        hand = crew.here()
        simulated = self.clock_type == ClockType.ROS_TIME and self.ros_time_is_active
        if hand is None or not simulated or until.clock_type != self.clock_type:
            return plain_sleep_until(self, until, context)
        if self.now() < until:
            hand.wait_for(lambda: self.now() >= until, until.nanoseconds)
        return True

    def sleep(seconds):
        hand = crew.here()
        if hand is None:
            return _plain_sleep(seconds)
        awake_at = time.monotonic() + seconds
        hand.wait_for(lambda: time.monotonic() >= awake_at, awake_at=awake_at)

    def lock():
        return _Lock() if sys._getframe(1).f_globals.get('__name__') == 'notebook' else plain_lock()

    threading.Condition.wait, Clock.sleep_until, time.sleep, threading.Lock = wait, sleep_until, sleep, lock
