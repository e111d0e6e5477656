"""The transform buffer of a node."""

from collections.abc import Callable
from threading import Condition
from time import monotonic

from geometry_msgs.msg import TransformStamped
from rclpy.clock import Clock, JumpThreshold, TimeJump
from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.task import Future
from rclpy.time import Time
from tf2_msgs.srv import FrameGraph
from tf2_py import BufferCore

from tf2_ros.buffer_interface import NO_TIMEOUT, BufferInterface


class Buffer(BufferCore, BufferInterface):
    """
    A :class:`tf2_py.BufferCore` that can wait for transforms and transforms stamped objects.

    Waiting is by wall time, also where nodes use simulated time. A blocking wait needs somebody else to receive the
    transforms meanwhile: a `MultiThreadedExecutor`, a listener with `spin_thread=True`, or another thread. Where
    there is none, `await` one of the `…_async` methods instead.

    :param cache_time: how long history is kept; 10 s by default.
    :param node: if given, it gets a service `tf2_frames` that tells the frames, and its clock is the buffer's: when
        that jumps back by a second or more, the history is cleared.
    """

    def __init__(self, cache_time: Duration | None = None, node: Node | None = None) -> None:
        BufferCore.__init__(self, *([] if cache_time is None else [cache_time]))
        BufferInterface.__init__(self)
        self._news = Condition()  # notified after every insertion
        self._waiters: list[Callable[[], bool]] = []  # each tries to complete its future, and says whether it is done
        if node is not None:
            self.srv = node.create_service(FrameGraph, 'tf2_frames', self._tell_frames)
            self.clock = node.get_clock()
        else:
            self.clock = Clock()
        threshold = JumpThreshold(min_forward=None, min_backward=Duration(seconds=-1), on_clock_change=True)
        self.jump_handle = self.clock.create_jump_callback(threshold, post_callback=self.time_jump_callback)

    def _tell_frames(self, request: FrameGraph.Request, response: FrameGraph.Response) -> FrameGraph.Response:
        response.frame_yaml = self.all_frames_as_yaml()
        return response

    def time_jump_callback(self, time_jump: TimeJump) -> None:
        """Clear the history: stamps from before a jump back would be in the future now."""
        get_logger('tf2_buffer').warning('Detected jump back in time. Clearing tf buffer.')
        self.clear()

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Add a transform, see :meth:`tf2_py.BufferCore.set_transform`, and wake who waits for it."""
        super().set_transform(transform, authority)
        self._announce()

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Add a static transform and wake who waits for it."""
        super().set_transform_static(transform, authority)
        self._announce()

    def _announce(self) -> None:
        with self._news:
            self._news.notify_all()
            if self._waiters:
                # Completing a future may run code that adds waiters: these go to the new list.
                waiters, self._waiters = self._waiters, []
                self._waiters = [waiter for waiter in waiters if not waiter()] + self._waiters

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIMEOUT
    ) -> TransformStamped:
        """
        Return the transform that takes data from the source frame into the target frame.

        :param time: when; 0 means the latest time at which it is known.
        :param timeout: how long to wait for it.
        :raises tf2_py.TransformException: see :meth:`tf2_py.BufferCore.lookup_transform_core`.
        """
        self.can_transform(target_frame, source_frame, time, timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
    ) -> TransformStamped:
        """
        Return the transform from the source frame at one time into the target frame at another.

        :param fixed_frame: the frame that did not move between the two times.
        """
        self.can_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Time) -> TransformStamped:
        """Await the transform, however long it takes, and return it."""
        return await self.wait_for_transform_async(target_frame, source_frame, time)

    async def lookup_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> TransformStamped:
        """Await the transform between two times, however long it takes, and return it."""
        return await self.wait_for_transform_full_async(
            target_frame, target_time, source_frame, source_time, fixed_frame
        )

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_TIMEOUT,
        return_debug_tuple: bool = False,
    ) -> int | tuple[int, str]:
        """
        Return 1 if the transform is known, or becomes known within the timeout, else 0.

        :param return_debug_tuple: return `(1, '')` or `(0, why not)` instead.
        """
        answer = self._wait(lambda: self.can_transform_core(target_frame, source_frame, time), timeout)
        return answer if return_debug_tuple else answer[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
        return_debug_tuple: bool = False,
    ) -> int | tuple[int, str]:
        """Like :meth:`can_transform`, between two times."""
        answer = self._wait(
            lambda: self.can_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame),
            timeout,
        )
        return answer if return_debug_tuple else answer[0]

    def _wait(self, ask: Callable[[], tuple[int, str]], timeout: Duration) -> tuple[int, str]:
        """Return the first positive answer, or the last one before the timeout."""
        answer = ask()
        if answer[0] or timeout.nanoseconds <= 0:
            return answer
        deadline = monotonic() + timeout.nanoseconds / 1e9
        with self._news:
            while True:
                answer = ask()
                rest = deadline - monotonic()
                if answer[0] or rest <= 0:
                    return answer
                self._news.wait(rest)

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Future:
        """Return a future whose result will be the transform. Cancel it to stop waiting."""
        return self._future(
            lambda: self.can_transform_core(target_frame, source_frame, time),
            lambda: self.lookup_transform_core(target_frame, source_frame, time),
        )

    def wait_for_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> Future:
        """Return a future whose result will be the transform between two times. Cancel it to stop waiting."""
        question = (target_frame, target_time, source_frame, source_time, fixed_frame)
        return self._future(
            lambda: self.can_transform_full_core(*question), lambda: self.lookup_transform_full_core(*question)
        )

    def _future(self, ask: Callable[[], tuple[int, str]], look_up: Callable[[], TransformStamped]) -> Future:
        future = Future()

        def completed() -> bool:
            if future.done() or future.cancelled():
                return True
            try:
                if not ask()[0]:
                    return False
                result = look_up()
            except Exception as error:  # for who awaits it, not for who happened to send a transform
                future.set_exception(error)
            else:
                future.set_result(result)
            return True

        with self._news:  # no transform can slip in between asking and beginning to wait
            if not completed():
                self._waiters.append(completed)
        return future
