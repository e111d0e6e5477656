"""Lets `try_shutdown` succeed when a signal shuts the context down at the same moment (runs inside of rclpy 7.1.6).

After Ctrl+C a thread of rclpy's shuts the contexts down, while the program's own main catches KeyboardInterrupt and
calls `try_shutdown`. That looks whether the context is still valid, and then shuts it down: if the thread comes in
between, rcl says "rcl_shutdown already called", and the program ends with a traceback and the status 1, as 1 of 60 did
on a busy machine. Upstream has mended it in a later version (ros2/rclpy#1352).
"""

import functools
import time

LONGEST = 1.0  # s until the other one has shut the context down; it is doing nothing else
_LOOK = 0.002  # s


def patch(context_class):
    """Make `try_shutdown` of `context_class` succeed if somebody else has shut the context down; returns the class."""
    shut_down = context_class.try_shutdown

    @functools.wraps(shut_down)
    def try_shutdown(self):
        from rclpy.impl.implementation_singleton import rclpy_implementation

        end = time.monotonic() + LONGEST
        try:
            shut_down(self)
        except rclpy_implementation.RCLError:
            while self.ok():
                if time.monotonic() > end:
                    raise
                time.sleep(_LOOK)

    context_class.try_shutdown = try_shutdown
    return context_class
