"""Threads of the learner's own that sleep on a rate of rclpy: a step of simulated time ends when they rest again.

A rate wakes its thread in real time, whenever the machine gets to it. What the thread does then belongs to the moment
of simulated time at which the rate's timer was due, so the step waits for it.
"""

import functools
import sys
import threading
import time

import rclpy
from rclpy.exceptions import ROSInterruptException
from rclpy.timer import Rate

from helpers.runner.mistakes import MistakeWatch

LONGEST = 0.5  # seconds of wall time for which a thread is waited for: it may do something else than sleep on a rate


class Sleepers:
    """Which threads sleep on which rate, and which ones have work to do first."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._asleep: dict[threading.Thread, Rate] = {}
        self._awake: set[threading.Thread] = set()

    def starts(self, thread: threading.Thread) -> None:
        """The learner starts this thread: it may be on its way to a rate."""
        with self._lock:
            self._awake.add(thread)

    def sleeps(self, thread: threading.Thread, rate: Rate) -> None:
        """The thread has come to a rate."""
        with self._lock:
            self._awake.discard(thread)
            self._asleep[thread] = rate

    def fires(self, rate: Rate) -> None:
        """The timer of the rate is due: whoever sleeps on it will wake."""
        with self._lock:
            woken = [thread for thread, one in self._asleep.items() if one is rate]
            self._awake.update(woken)
            for thread in woken:
                del self._asleep[thread]

    def rest(self) -> bool:
        """Wait until all threads that are awake have come back to a rate or have ended; whether there were any."""
        end, waited = time.monotonic() + LONGEST, False
        while True:
            with self._lock:
                self._awake = {thread for thread in self._awake if thread.ident is None or thread.is_alive()}
                if not self._awake or time.monotonic() > end:
                    self._awake.clear()
                    return waited
            waited = True
            time.sleep(0.001)  # a bounded poll: the end of a thread notifies nobody


def watch(sleepers: Sleepers, seen: MistakeWatch) -> None:
    """Tell `sleepers` of the threads that lines of the learner's start, and of what they do with rates."""
    start, create, sleep = threading.Thread.start, Rate.__init__, Rate.sleep

    @functools.wraps(start)
    def started(self):
        if seen.is_learners(sys._getframe(1)):
            sleepers.starts(self)
        return start(self)

    @functools.wraps(create)
    def made(self, timer, *, context):
        create(self, timer, context=context)
        fire = timer.callback

        def fired():
            sleepers.fires(self)
            fire()

        timer.callback = fired

    @functools.wraps(sleep)
    def slept(self):
        thread = threading.current_thread()
        if thread is not threading.main_thread() and not seen.in_callback():
            sleepers.sleeps(thread, self)
        return sleep(self)

    show = threading.excepthook

    def raised(arguments):
        # A rate that is slept on raises when the test is over: that is no fault of the thread.
        if not issubclass(arguments.exc_type, ROSInterruptException) and rclpy.ok():
            show(arguments)

    threading.excepthook = raised
    # Replaced on purpose, which no type of theirs allows.
    threading.Thread.start, Rate.__init__, Rate.sleep = started, made, slept  # type: ignore[method-assign]
