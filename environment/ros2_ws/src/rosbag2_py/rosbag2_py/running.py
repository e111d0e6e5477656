"""A node for as long as a bag is recorded or played, in a context of its own."""

import signal
import threading
import time
from collections.abc import Callable
from types import TracebackType

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.signals import SignalHandlerOptions

_LONGEST_WAIT = 0.1  # seconds after which a wait looks whether Ctrl+C was pressed
_IDLE = 5  # times that nothing was ready: an executor may have something else to do in between


class RunningNode:
    """
    A context manager with a node, `node`, that is spun by :meth:`spin`.

    Ctrl+C and SIGTERM end :meth:`spin`, never in the middle of a callback, so that a file can be completed.
    """

    def __init__(self, name: str, use_sim_time: bool = False, handle_signals: bool = True):
        """
        Remember the name; the node is made when the context is entered.

        :param handle_signals: False leaves Ctrl+C and SIGTERM to the program.
        """
        self._name, self._use_sim_time, self._handle_signals = name, use_sim_time, handle_signals
        self._signal = 0

    def __enter__(self) -> 'RunningNode':
        """Make the node."""
        self.context = rclpy.Context()
        # rclpy's own handlers would make the context invalid before the file is complete.
        rclpy.init(args=[], context=self.context, signal_handler_options=SignalHandlerOptions.NO)
        # Python lets only the main thread handle signals. In another one, who started it has to end it.
        can_handle = self._handle_signals and threading.current_thread() is threading.main_thread()
        handled = (signal.SIGINT, signal.SIGTERM) if can_handle else ()
        self._handlers = {each: signal.signal(each, self._note) for each in handled}
        self.node = rclpy.create_node(
            self._name,
            context=self.context,
            start_parameter_services=False,
            parameter_overrides=[Parameter('use_sim_time', value=self._use_sim_time)],
        )
        self._executor = SingleThreadedExecutor(context=self.context)
        self._executor.add_node(self.node)
        return self

    def __exit__(self, kind: type | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        """Leave the graph."""
        try:
            self._executor.shutdown(timeout_sec=1.0)
            self.node.destroy_node()
            rclpy.try_shutdown(context=self.context)
        finally:
            for number, handler in self._handlers.items():
                signal.signal(number, handler)

    def spin(self, until: Callable[[], object] = lambda: False, timeout: float | None = None) -> None:
        """
        Run callbacks until the condition holds, or for `timeout` seconds.

        :raises KeyboardInterrupt: after Ctrl+C.
        :raises SystemExit: after SIGTERM, with status 143.
        """
        end = None if timeout is None else time.monotonic() + timeout
        while not until():
            wait = _LONGEST_WAIT if end is None else min(_LONGEST_WAIT, end - time.monotonic())
            if wait <= 0:
                break
            self._executor.spin_once(timeout_sec=wait)
            self._end_if_told()
        self._end_if_told()

    def spin_ready(self, done: Callable[[], int], timeout: float = 1.0) -> None:
        """Run the callbacks of what has come already: until `done` counts no more, for at most `timeout` seconds."""
        end, idle = time.monotonic() + timeout, 0
        while idle < _IDLE and time.monotonic() < end:
            before = done()
            self._executor.spin_once(timeout_sec=0)
            idle = 0 if done() > before else idle + 1

    def _note(self, number: int, _: object) -> None:
        if self._signal:  # a second time: at once
            raise KeyboardInterrupt
        self._signal = number

    def _end_if_told(self) -> None:
        if self._signal == signal.SIGINT:
            raise KeyboardInterrupt
        if self._signal:
            raise SystemExit(128 + self._signal)
