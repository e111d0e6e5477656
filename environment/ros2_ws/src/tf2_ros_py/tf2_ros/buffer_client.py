"""Ask a buffer in another process."""

from threading import Event
from time import monotonic
from warnings import warn

import builtin_interfaces.msg
from geometry_msgs.msg import TransformStamped
from rclpy.action.client import ActionClient
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.task import Future
from rclpy.time import Time
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TF2Error
from tf2_py import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

from tf2_ros.buffer_interface import NO_TIMEOUT, BufferInterface

# How much longer than a look-up's own timeout the server may take.
PADDING = Duration(seconds=2.0)

_EXCEPTIONS = {
    TF2Error.LOOKUP_ERROR: LookupException,
    TF2Error.CONNECTIVITY_ERROR: ConnectivityException,
    TF2Error.EXTRAPOLATION_ERROR: ExtrapolationException,
    TF2Error.INVALID_ARGUMENT_ERROR: InvalidArgumentException,
    TF2Error.TIMEOUT_ERROR: TimeoutException,
}


class BufferClient(BufferInterface):
    """
    A buffer whose transforms are in a buffer server (`ros2 run tf2_ros buffer_server`), asked by an action.

    The methods block: the node must be spun by another thread meanwhile.

    :param node: the node that asks.
    :param ns: the name of the server's action, as `tf2_buffer_server`.
    :param check_frequency: accepted for upstream's signature; the client is woken by the answer and polls nothing.
    :param timeout_padding: how much longer than a look-up's own timeout to wait for the server.
    """

    def __init__(self, node: Node, ns: str, check_frequency: float = 10.0, timeout_padding: Duration = PADDING) -> None:
        super().__init__()
        self.node = node
        self.action_client = ActionClient(node, LookupTransform, action_name=ns)
        self.check_frequency = check_frequency
        self.timeout_padding = timeout_padding

    def destroy(self) -> None:
        """Take the action client off the node; the client is of no use afterwards."""
        self.action_client.destroy()

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIMEOUT
    ) -> TransformStamped:
        """
        Return the transform from the source frame to the target frame.

        :raises tf2_py.TimeoutException: if the server is not there or does not answer.
        :raises tf2_py.TransformException: what the server's buffer raised.
        """
        goal = LookupTransform.Goal(target_frame=target_frame, source_frame=source_frame, advanced=False)
        goal.source_time = _message(time)
        goal.timeout = timeout.to_msg()
        return self._result_of(goal, timeout)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
    ) -> TransformStamped:
        """Return the transform between two times. Raises as :meth:`lookup_transform`."""
        goal = LookupTransform.Goal(
            target_frame=target_frame, source_frame=source_frame, fixed_frame=fixed_frame, advanced=True
        )
        goal.source_time = _message(source_time)
        goal.target_time = _message(target_time)
        goal.timeout = timeout.to_msg()
        return self._result_of(goal, timeout)

    def can_transform(self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIMEOUT) -> bool:
        """Return whether :meth:`lookup_transform` would succeed."""
        try:
            self.lookup_transform(target_frame, source_frame, time, timeout)
        except TransformException:
            return False
        return True

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
    ) -> bool:
        """Return whether :meth:`lookup_transform_full` would succeed."""
        try:
            self.lookup_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        except TransformException:
            return False
        return True

    def _result_of(self, goal: LookupTransform.Goal, timeout: Duration) -> TransformStamped:
        if not self.action_client.server_is_ready():
            raise TimeoutException('The BufferServer is not ready.')
        deadline = monotonic() + _seconds(timeout) + _seconds(self.timeout_padding)
        handle = self._wait(self.action_client.send_goal_async(goal), deadline)
        if not handle.accepted:
            raise TimeoutException(
                'The LookupTransform goal sent to the BufferServer did not come back with '
                'accepted status. Something is likely wrong with the server.'
            )
        result = self._wait(handle.get_result_async(), deadline).result
        if result.error.error != TF2Error.NO_ERROR:
            raise _EXCEPTIONS.get(result.error.error, TransformException)(result.error.error_string)
        return result.transform

    def _wait(self, future: Future, deadline: float):
        answered = Event()
        future.add_done_callback(lambda _: answered.set())
        if not answered.wait(max(0.0, deadline - monotonic())):
            raise TimeoutException(
                'The LookupTransform goal sent to the BufferServer did not come back in the '
                'specified time. Something is likely wrong with the server.'
            )
        return future.result()


def _message(time: Time) -> builtin_interfaces.msg.Time:
    if isinstance(time, Time):
        return time.to_msg()
    if isinstance(time, builtin_interfaces.msg.Time):
        warn(
            'Passing a builtin_interfaces.msg.Time argument is deprecated, and will be removed in the near future. '
            'Use rclpy.time.Time instead.',
            stacklevel=3,
        )
        return time
    raise TypeError('Must pass a rclpy.time.Time object.')


def _seconds(duration: Duration | float) -> float:
    return duration.nanoseconds / 1e9 if isinstance(duration, Duration) else float(duration)
