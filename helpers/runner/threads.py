"""Callbacks in threads, one at a time, as a MultiThreadedExecutor runs them, but in an order that never changes.

A callback may wait in its thread: on the node's clock, on a rate, on an event or a condition, or in a client's `call`.
Then the main thread goes on, and lets the callback continue once what it waits for has come. So the main thread knows
when every callback has either returned or waits; then simulated time may go on.

Only these waits are known: `Clock.sleep_for` and `sleep_until` on simulated time, everything built on
`threading.Condition` (Event, Semaphore, queue.Queue, rclpy's Rate and `Client.call`), `threading.Lock` and `RLock` in
the learner's own code, and `time.sleep`, which waits on the wall clock. A timeout is counted in simulated time.

Real threads may also change in the middle of a callback. `ThreadPool.switch` brings that about, at a line of the
learner's that the test names, or within it: so a test can try one place after the other, and finds each time what
is not protected.
"""

import _thread
import opcode
import sys
import threading
import time
import traceback
from collections.abc import Callable
from types import CodeType

from rclpy.clock import Clock, ClockType

SLEEP_LIMIT = 1.0  # seconds of wall time that callbacks may sleep at one moment of simulated time
SECOND = 1_000_000_000
# A line may do several things: these change what threads share, or look it up.
_STORES = {opcode.opmap[name] for name in ('STORE_ATTR', 'STORE_SUBSCR', 'DELETE_SUBSCR')}
_CALLS = {number for name, number in opcode.opmap.items() if name.startswith('CALL')}
_LOADS = {
    number for name, number in opcode.opmap.items() if name.startswith(('LOAD_FAST', 'LOAD_GLOBAL', 'LOAD_DEREF'))
}


class Sleeps(Exception):
    """A callback sleeps with `time.sleep`, for longer than SLEEP_LIMIT, while simulated time stands still."""

    def __init__(self, frame):
        super().__init__('time.sleep in a callback')
        self.frame = frame


class _PoolThread(threading.Thread):
    """A thread of the pool: it works or waits only while the main thread stands still."""

    def __init__(self, pool: 'ThreadPool'):
        super().__init__(daemon=True)
        self.pool = pool
        self.work: tuple | None = None  # (handler, entity, node)
        self.ready: Callable[[], bool] | None = None  # while it waits: whether it may go on
        self.due: int | None = None  # simulated time (ns) at which it goes on by itself
        self.awake_at: float | None = None  # wall time (monotonic) at which its time.sleep ends
        self.acted = False  # whether the line at which it is has just called or changed something
        self.turn = _thread.allocate_lock()
        self.turn.acquire()

    def run(self) -> None:
        while True:
            self.turn.acquire()
            assert self.work is not None  # who gives the turn has set it
            handler, *_ = self.work
            sys.settrace(self.pool.trace if self.pool.switches else None)
            try:
                handler()
            except BaseException as error:  # noqa: BLE001 - SystemExit passes through rclpy's own handling
                self.pool.raised[id(handler)] = error
            self.pool.ended.append(self.work)
            self.work = None
            self.pool.idle.append(self)
            self.pool.back.release()

    def wait_for(self, ready: Callable[[], bool], due: int | None = None, awake_at: float | None = None) -> None:
        """Let the main thread go on until `ready()`; called in this thread."""
        self.ready, self.due, self.awake_at = ready, due, awake_at
        self.pool.waiting.append(self)
        self.pool.back.release()
        self.turn.acquire()
        self.ready = self.due = self.awake_at = None


class ThreadPool:
    """The threads of a process.

    :param now: gives the simulated time in nanoseconds.
    :param switches: whether `switch` may be used, which costs time.
    :param more: whether there is something to run besides what is ready in the executor.
    """

    def __init__(self, now: Callable[[], int], switches: bool = False, more: Callable[[], bool] = lambda: False):
        self.now, self.switches, self._more = now, switches, more
        self.lines = 0  # places in the learner's lines to which threads have come since the last call of `switch`
        self._codes: dict[CodeType, bytes] = {}
        self.stood: traceback.StackSummary | None = None  # the line at which a thread has stood aside since then
        self._switch_at, self._hold = 0, False
        self._aside: _PoolThread | None = None  # stands aside until nothing else can go on
        self.idle: list[_PoolThread] = []
        self.waiting: list[_PoolThread] = []
        self.ended: list[tuple] = []  # work that has ended: (handler, entity, node)
        self.raised: dict[int, BaseException] = {}  # by the id of the handler: what left it
        self.current: _PoolThread | None = None
        self.back = _thread.allocate_lock()
        self.back.acquire()
        self._slept = (-1, 0.0)  # at which simulated time, for how long
        _patch(self)

    def run(self, handler, entity, node) -> bool:
        """Run a ready callback until it returns (then it is in `ended`) or waits; returns whether it waits."""
        thread = self.idle.pop() if self.idle else self._new_thread()
        thread.work = (handler, entity, node)
        self._give_turn(thread)
        return thread.work is not None

    def switch(self, line: int, hold: bool) -> None:
        """Let the thread that comes to the place with this number, counted from now on, stand aside.

        Places are before each line of the learner's, and in it before each store, and after each call and each store.
        It goes on when nothing else can; with `hold` not before the next call. 0: none stands aside.
        """
        self.lines, self.stood, self._switch_at, self._hold = 0, None, line, hold

    def trace(self, frame, event, arg):
        """The trace function of the threads: it counts the places in the learner's lines, in their cells only."""
        if frame.f_globals.get('__name__') != 'notebook':
            return None
        frame.f_trace_opcodes = True
        thread = self.here()
        if thread is not None and self._is_place(frame, event, thread):
            self.lines += 1
            if self.lines == self._switch_at and self._aside is None:
                self.stood = traceback.StackSummary.extract(iter([(frame, frame.f_lineno)]))
                self._aside = thread
                thread.wait_for(lambda: False)
        return self.trace

    def _is_place(self, frame, event, thread: _PoolThread) -> bool:
        """Whether a thread has come to one of the places of `switch`."""
        if event == 'line':
            thread.acted = False
            return True
        if event != 'opcode':
            return False
        code = self._codes.get(frame.f_code)
        if code is None:  # Python makes the bytes anew each time when it is asked
            code = self._codes[frame.f_code] = frame.f_code.co_code
        number = code[frame.f_lasti]
        goes_on = thread.acted and number in _LOADS
        thread.acted = number in _CALLS or number in _STORES or (thread.acted and not goes_on)
        return goes_on or number in _STORES

    def resume(self) -> bool:
        """Let every thread go on whose wait is over; returns whether there was one. Waits until a `time.sleep` ends.

        It is called when nothing is ready in the executor: so one that stands aside goes on if there is no other.
        """
        ready = [thread for thread in self.waiting if thread.ready is not None and thread.ready()]
        if not ready:
            sleepers = {thread: thread.awake_at for thread in self.waiting if thread.awake_at is not None}
            if sleepers:
                thread = min(sleepers, key=sleepers.__getitem__)
                self._sleep(thread, sleepers[thread])
                ready = [thread]
        if not ready and self._aside is not None and not self._hold and not self._more():
            ready, self._aside = [self._aside], None
        for thread in ready:
            self.waiting.remove(thread)
            self._give_turn(thread)
        return bool(ready)

    def next_due(self) -> int | None:
        """The simulated time (ns) at which the next wait is over by itself."""
        return min((thread.due for thread in self.waiting if thread.due is not None), default=None)

    def here(self) -> '_PoolThread | None':
        """The thread of this pool in which the caller runs."""
        thread = threading.current_thread()
        return thread if isinstance(thread, _PoolThread) and thread.pool is self else None

    def frame(self, thread: _PoolThread | None = None):
        """The innermost frame of a thread; of the one that has its turn, if none is given. None if there is none."""
        thread = thread or self.current
        return sys._current_frames().get(thread.ident) if thread and thread.ident is not None else None

    def _new_thread(self) -> _PoolThread:
        thread = _PoolThread(self)
        thread.start()
        return thread

    def _give_turn(self, thread: _PoolThread) -> None:
        self.current = thread
        thread.turn.release()
        self.back.acquire()
        self.current = None

    def _sleep(self, thread: _PoolThread, awake_at: float) -> None:
        left = max(0.0, awake_at - time.monotonic())
        moment, slept = self._slept
        slept = left + (slept if moment == self.now() else 0.0)
        if slept > SLEEP_LIMIT:
            raise Sleeps(self.frame(thread))
        self._slept = (self.now(), slept)
        _plain_sleep(left)


class _Waiter:
    """What a Condition notifies: the place of the lock on which a plain thread would block."""

    def __init__(self):
        self.notified = False

    def release(self) -> None:
        self.notified = True


class _Lock:
    """A lock on which a thread of the pool may wait while another one holds it."""

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


class _RLock(_Lock):
    """The same, for a lock that its holder may take again."""

    def __init__(self):
        super().__init__()
        self._take, self._owner, self._count = self.acquire, 0, 0
        self.acquire = self._acquire

    def _acquire(self, blocking: bool = True, timeout: float | None = None) -> bool:
        if not self._is_owned():
            if not self._take(blocking, timeout if blocking and timeout is not None and timeout >= 0 else None):
                return False
            self._owner = threading.get_ident()
        self._count += 1
        return True

    def release(self) -> None:
        if not self._is_owned():
            raise RuntimeError('cannot release un-acquired lock')
        self._count -= 1
        if not self._count:
            self._owner = 0
            super().release()

    # What a Condition asks of its lock

    def _is_owned(self) -> bool:
        return self._owner == threading.get_ident()

    def _release_save(self) -> int:
        count, self._count = self._count, 1
        self.release()
        return count

    def _acquire_restore(self, count: int) -> None:
        self._acquire()
        self._count = count


_plain_sleep = time.sleep


def patch_locks() -> None:
    """From now on, make the locks of the learner's own code such that threads of a pool may wait on them.

    It comes before their cells are run: a class or a constructor may make a lock before there is a pool.
    """
    plain_lock, plain_rlock = threading.Lock, threading.RLock

    def learners(frame) -> bool:
        return frame.f_globals.get('__name__') == 'notebook'

    def lock():
        return _Lock() if learners(sys._getframe(1)) else plain_lock()

    def rlock():
        caller = sys._getframe(1)
        if caller.f_code is threading.Condition.__init__.__code__:  # a Condition makes one for whoever makes it
            caller = caller.f_back
        return _RLock() if learners(caller) else plain_rlock()

    threading.Lock, threading.RLock = lock, rlock  # type: ignore[assignment]  # on purpose


def _patch(pool: ThreadPool) -> None:
    """In threads of the pool, make the known waits give the turn back; elsewhere they stay what they are."""
    plain_wait, plain_sleep_until = threading.Condition.wait, Clock.sleep_until

    def wait(self, timeout=None):
        thread = pool.here()
        if thread is None:
            return plain_wait(self, timeout)
        if not self._is_owned():
            raise RuntimeError('cannot wait on un-acquired lock')
        waiter = _Waiter()
        self._waiters.append(waiter)
        saved = self._release_save()
        due = None if timeout is None else pool.now() + max(0, round(timeout * SECOND))
        try:
            thread.wait_for(lambda: waiter.notified or (due is not None and pool.now() >= due), due)
        finally:
            self._acquire_restore(saved)
            if not waiter.notified:
                self._waiters.remove(waiter)
        return waiter.notified

    def sleep_until(self, until, context=None):
        thread = pool.here()
        simulated = self.clock_type == ClockType.ROS_TIME and self.ros_time_is_active
        if thread is None or not simulated or until.clock_type != self.clock_type:
            return plain_sleep_until(self, until, context)
        if self.now() < until:
            thread.wait_for(lambda: self.now() >= until, until.nanoseconds)
        return True

    def sleep(seconds):
        thread = pool.here()
        if thread is None:
            return _plain_sleep(seconds)
        awake_at = time.monotonic() + seconds
        thread.wait_for(lambda: time.monotonic() >= awake_at, awake_at=awake_at)

    # Replaced on purpose, which no type of theirs allows.
    threading.Condition.wait, Clock.sleep_until = wait, sleep_until  # type: ignore[method-assign]
    time.sleep = sleep
