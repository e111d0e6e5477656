"""Lets a program that spins end by SIGTERM, each time (runs inside of rclpy 7.1.6).

After a signal a thread of rclpy's first wakes the executors, and then shuts the contexts down (`signal_handler.cpp`).
An executor that is quick finds its context as it was, waits again, and nobody wakes it any more: on a busy machine 4 of
60 nodes without work went on after a SIGTERM, as `timeout` and `kill` send it. (After a SIGINT there is also Python's
KeyboardInterrupt.) Here who was woken by a signal waits for the shutdown that follows.
"""

import time

LONGEST = 1.0  # s from the wake-up to the shutdown; the thread has nothing else to do in between
_LOOK = 0.002  # s


def patch(guard_class):
    """Make guard conditions of `guard_class`, which signals trigger, wait for the end of their context; returns it.

    The executor sets `_executor_triggered` directly after its wait, where it would raise ExternalShutdownException by
    itself if the context were shut down already.
    """

    def triggered(self):
        return self.__dict__['_course_triggered']

    def trigger(self, value):
        self.__dict__['_course_triggered'] = value
        if value:
            _wait_for_shutdown(self._context)

    guard_class._executor_triggered = property(triggered, trigger)
    return guard_class


def _wait_for_shutdown(context):
    """Wait until the context is shut down, for a second at most.

    :raises ExternalShutdownException: it is.
    """
    from rclpy.executors import ExternalShutdownException

    end = time.monotonic() + LONGEST
    while context.ok():
        if time.monotonic() > end:
            return
        time.sleep(_LOOK)
    raise ExternalShutdownException
