"""Serve a transform buffer to other processes by the action `tf2_buffer_server`; see `tf2_ros.BufferClient`."""

from node_program.running import run
from rclpy.action import ActionServer
from rclpy.clock import Clock, ClockType
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
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

ERRORS = {
    LookupException: TF2Error.LOOKUP_ERROR,
    ConnectivityException: TF2Error.CONNECTIVITY_ERROR,
    ExtrapolationException: TF2Error.EXTRAPOLATION_ERROR,
    InvalidArgumentException: TF2Error.INVALID_ARGUMENT_ERROR,
    TimeoutException: TF2Error.TIMEOUT_ERROR,
}


class BufferServer(Node):
    """Listens to transforms and answers goals; the parameter `buffer_size` is how many seconds of history it keeps."""

    def __init__(self):
        super().__init__('tf_buffer')
        size = self.declare_parameter('buffer_size', 120.0).value
        self.buffer = Buffer(Duration(seconds=size), node=self)
        self.listener = TransformListener(self.buffer, self)
        self.server = ActionServer(self, LookupTransform, 'tf2_buffer_server', self.execute)

    async def execute(self, handle):
        """Answer one goal as soon as the transform is known, or when its timeout is over."""
        goal = handle.request
        source_time, target_time = Time.from_msg(goal.source_time), Time.from_msg(goal.target_time)
        if goal.advanced:
            question = goal.target_frame, target_time, goal.source_frame, source_time, goal.fixed_frame
            wait, look_up = self.buffer.wait_for_transform_full_async, self.buffer.lookup_transform_full
        else:
            question = goal.target_frame, goal.source_frame, source_time
            wait, look_up = self.buffer.wait_for_transform_async, self.buffer.lookup_transform
        timeout = Duration.from_msg(goal.timeout).nanoseconds / 1e9
        known = wait(*question)
        if timeout > 0.0 and not known.done():
            await self.known_or_late(known, timeout)
        known.cancel()
        result = LookupTransform.Result()
        try:
            result.transform = look_up(*question)
            handle.succeed()
        except TransformException as error:
            result.error.error = ERRORS.get(type(error), TF2Error.TRANSFORM_ERROR)
            result.error.error_string = str(error)
            handle.abort()
        return result

    async def known_or_late(self, known, timeout):
        """Await the future, but at most so many seconds of wall time."""
        woken = Future(executor=self.executor)

        def wake(_=None):
            if not woken.done():
                woken.set_result(None)

        timer = self.create_timer(timeout, wake, clock=Clock(clock_type=ClockType.STEADY_TIME))
        known.add_done_callback(wake)
        await woken
        self.destroy_timer(timer)


def main():
    """Run the program."""
    run(BufferServer)
